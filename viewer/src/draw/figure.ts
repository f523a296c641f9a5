/** Surface of one instance, with the vertices posed by the worker. */

import { BufferAttribute, BufferGeometry, Mesh, MeshStandardMaterial } from 'three';
import type { CharacterFacts, PosedInstance } from '../worker/protocol';
import { bodyColour } from './colours';
import { upload } from './upload';

export class Figure extends Mesh<BufferGeometry, MeshStandardMaterial> {
  constructor(
    readonly character: CharacterFacts,
    instance: number,
  ) {
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(character.triangles, 1));
    super(geometry, new MeshStandardMaterial({ color: bodyColour(instance), roughness: 0.62 }));
    this.castShadow = true;
    this.receiveShadow = true;
    this.frustumCulled = false; // otherwise its bounds must be recomputed in each frame
  }

  show({ positions, normals }: PosedInstance): void {
    upload(this.geometry, 'position', positions);
    upload(this.geometry, 'normal', normals);
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
