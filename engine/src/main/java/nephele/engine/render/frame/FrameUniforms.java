package nephele.engine.render.frame;

import nephele.engine.level.Environment;
import nephele.engine.level.appearance.FogVeil;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.scene.View;
import org.joml.Matrix4d;

/** The uniform block {@code Frame} of {@code frame.glsl}: what every shader knows of the view. */
public final class FrameUniforms implements AutoCloseable {
    /** Binding point of the block; passes use others. */
    public static final int BINDING = 0;

    private static final int FLOATS = 16 + 6 * 4;

    private final UniformBuffer buffer;
    private final float[] values = new float[FLOATS];
    private final Matrix4d matrix = new Matrix4d();

    /** @param environment does not change from frame to frame */
    FrameUniforms(GlContext gl, Environment environment) {
        buffer = new UniformBuffer(gl, "frame uniforms", FLOATS);
        FogVeil.of(environment).ifPresent(fog -> {
            put(36, fog.radiance(), 1);
            values[39] = (float) fog.extinctionPerMetre();
        });
    }

    /** @param exposure factor on radiance before the tone curve */
    public void upload(View view, double exposure) {
        view.clipFromRelative(matrix).get(values);
        put(16, view.right(), view.projection().tanHalfWidth());
        put(20, view.up(), view.projection().tanHalfHeight());
        put(24, view.back(), -1);
        values[28] = (float) exposure;
        putClip(view);
        buffer.upload(values);
        buffer.bind(BINDING);
    }

    private void putClip(View view) {
        // Mesa's llvmpipe 22.3 may go on cutting by a distance that was just switched off: cut nothing then.
        put(32, view.clip() == null ? Vec3.ZERO : view.clip().normal(), 1);
        values[35] = view.clip() == null ? 1 : (float) view.clip().signedDistance(view.eye());
    }

    private void put(int at, Vec3 v, double factor) {
        values[at] = (float) (v.x() * factor);
        values[at + 1] = (float) (v.y() * factor);
        values[at + 2] = (float) (v.z() * factor);
    }

    @Override
    public void close() {
        buffer.close();
    }
}
