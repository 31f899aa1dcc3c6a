// What polished balls and varnished wood mirror: the lamp over the table and a dim room, by Fresnel's law (Schlick 1994).
//
// Computed for each pixel from where the lamp hangs; cheaper than an environment map, and right for every place on the table.
import type { MeshLambertMaterial } from "three";
import type { Stage } from "./stage.ts";

const VERTEX_HEAD = `
varying vec3 polishNormal;
varying vec3 polishAt;
void main() {`;

const VERTEX_TAIL = `
  vec4 polishPlace = vec4(transformed, 1.0);
  #ifdef USE_INSTANCING
    polishPlace = instanceMatrix * polishPlace;
  #endif
  polishAt = (modelMatrix * polishPlace).xyz;
  polishNormal = inverseTransformDirection(transformedNormal, viewMatrix);
}`;

function room(stage: Stage, blur: number): string {
  const { cloth, floor } = stage;
  const [cx, cy] = [(cloth.x0 + cloth.x1) / 2, (cloth.y0 + cloth.y1) / 2];
  const [wide, tall] = [cloth.x1 - cloth.x0, cloth.y1 - cloth.y0];
  const long = Math.max(wide, tall);
  const number = (x: number): string => x.toFixed(5);
  const size = tall >= wide ? [0.12, 0.5] : [0.5, 0.12];
  return `
varying vec3 polishNormal;
varying vec3 polishAt;
vec3 polishRoom(vec3 at, vec3 ray) {
  vec3 seen = mix(vec3(0.04, 0.07, 0.055), vec3(0.34, 0.33, 0.31), smoothstep(-0.15, 0.5, ray.z));
  if (ray.z > 0.02) {
    vec2 hit = (at.xy - vec2(${number(cx)}, ${number(cy)}) + ray.xy * (${number(0.55 * long + floor)} - at.z) / ray.z) / ${number(long)};
    vec2 off = abs(hit) - vec2(${number(size[0])}, ${number(size[1])});
    seen += 13.0 * smoothstep(${number(blur)}, ${number(-blur)}, max(off.x, off.y)) * vec3(1.0, 0.95, 0.86);
  }
  return seen;
}`;
}

/** Adds the mirror image of the room to a material: `strength` 1 is a polished ball; `blur` softens the lamp. */
export function polish(material: MeshLambertMaterial, stage: Stage, strength: number, blur: number): void {
  const before = material.onBeforeCompile.bind(material);
  material.onBeforeCompile = (shader, renderer) => {
    before(shader, renderer);
    shader.vertexShader = shader.vertexShader.replace("void main() {", VERTEX_HEAD).replace(/\}\s*$/, VERTEX_TAIL);
    shader.fragmentShader = shader.fragmentShader.replace("void main() {", `${room(stage, blur)}\nvoid main() {`).replace(
      "#include <opaque_fragment>",
      `vec3 polishFrom = normalize(polishAt - cameraPosition);
       vec3 polishUp = normalize(polishNormal);
       float polishMirror = 0.04 + 0.96 * pow(1.0 - clamp(dot(-polishFrom, polishUp), 0.0, 1.0), 5.0);
       outgoingLight += ${strength.toFixed(3)} * polishMirror * polishRoom(polishAt, reflect(polishFrom, polishUp));
       #include <opaque_fragment>`,
    );
  };
  material.customProgramCacheKey = () => `polish ${strength} ${blur}`;
}
