package nephele.engine.render.pass.cloud;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.scene.View;

/** {@code spread.frag}, which completes a layer of which a frame has marched a share. */
final class SpreadProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    /** As far away as clouds count that a ray may have met before and does not meet now, with the eye in their bounds. */
    private static final double NEAREST_KILOMETRES = 0.02;

    private static final double SKY_KILOMETRES = 100;

    private final GlProgram<Places> program;

    private record Places(
            Uniforms.Vector2 layerStep,
            Uniforms.Vector3 square,
            Uniforms.Vector3 beforeRight,
            Uniforms.Vector3 beforeUp,
            Uniforms.Vector3 beforeForward,
            Uniforms.Vector3 moved,
            Uniforms.Vector2 halfLayer,
            Uniforms.Scalar nearestKilometres,
            Uniforms.Vector3 movedPast) {}

    /** The marched ray of each square of rays. */
    record Square(int side, int column, int row) {}

    SpreadProgram(LoadContext context) {
        program = GlProgram.of(
                context.gl(),
                FOLDER + "cloud.vert",
                FOLDER + "spread.frag",
                Defines.of(context).values(),
                Places.class);
    }

    /**
     * @param nearestMetres distance of the nearest cloud
     * @param nearestBlown how far the wind has carried it, metres
     * @param across pixels of the layer across the view, not rounded
     * @param upwards pixels of the layer from the view's lower to its upper side
     */
    void use(
            View before,
            View now,
            double nearestMetres,
            Vec3 nearestBlown,
            Square square,
            double across,
            double upwards) {
        program.use();
        Places places = program.uniforms();
        places.layerStep.set(2 / across, 2 / upwards);
        places.square.set(square.side(), square.column(), square.row());
        places.movedPast.set(
                now.eyeX() - before.eyeX() - nearestBlown.x(),
                now.eyeY() - before.eyeY() - nearestBlown.y(),
                now.eyeZ() - before.eyeZ() - nearestBlown.z());
        places.nearestKilometres.set(Math.max(NEAREST_KILOMETRES, Math.min(SKY_KILOMETRES, nearestMetres / 1000)));
        places.halfLayer.set(across / 2, upwards / 2);
        places.beforeRight.setScaled(before.right(), 1 / before.projection().tanHalfWidth());
        places.beforeUp.setScaled(before.up(), 1 / before.projection().tanHalfHeight());
        places.beforeForward.setScaled(before.back(), -1);
        places.moved.set(now.eyeX() - before.eyeX(), now.eyeY() - before.eyeY(), now.eyeZ() - before.eyeZ());
    }
}
