package nephele.engine.render.pass.thing;

import nephele.engine.render.frame.ThingMeshes.RunUniforms;
import nephele.engine.render.gl.Uniforms.Vector3;

/** What changes from view to view and from run to run. */
record ThingUniforms(Vector3 eyeHigh, Vector3 eyeLow, RunUniforms run) {
    void eye(float[] highAndLow) {
        eyeHigh.set(highAndLow[0], highAndLow[1], highAndLow[2]);
        eyeLow.set(highAndLow[3], highAndLow[4], highAndLow[5]);
    }
}
