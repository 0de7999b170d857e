package nephele.engine.render.pass.cloud;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.lightning.Bolt;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.scene.View;

/** The uniforms of {@code cloud-flash.glsl}: some points of a bolt from which it lights clouds. */
record FlashUniforms(List<Uniforms.Vector4> lights, Uniforms.Vector3 intensity) {
    /** Places of the lights on the main channel, which is brightest where it is in the cloud. */
    private static final double[] ALONG = {0, 0.12, 0.28, 0.55};

    private static final double[] SHARE = {0.4, 0.28, 0.2, 0.12};

    /** Number of lights. */
    static final int LIGHTS = ALONG.length;

    static FlashUniforms of(Uniforms uniforms) {
        return new FlashUniforms(
                IntStream.range(0, LIGHTS)
                        .mapToObj(i -> uniforms.vector4("flashLights[" + i + "]"))
                        .toList(),
                uniforms.vector3("flashIntensity"));
    }

    void put(FrameLightning lightning, View view) {
        Bolt bolt = lightning.lightning().bolt();
        Vec3 from = bolt.origin().minus(view.eye());
        for (int i = 0; i < LIGHTS; i++) {
            Vec3 place = from.plus(bolt.along(ALONG[i]));
            lights.get(i).set((float) place.x(), (float) place.y(), (float) place.z(), (float) SHARE[i]);
        }
        Vec3 radiant = lightning.radiantIntensity();
        intensity.set((float) radiant.x(), (float) radiant.y(), (float) radiant.z());
    }
}
