package nephele.engine.render.pass.cloud;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
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
            Uniforms.Vector2 step,
            Uniforms.Vector3 square,
            Uniforms.Vector3 right,
            Uniforms.Vector3 up,
            Uniforms.Vector3 forward,
            Uniforms.Vector3 moved,
            Uniforms.Vector2 half,
            Uniforms.Scalar nearest,
            Uniforms.Vector3 passed) {
        static Places of(Uniforms uniforms) {
            uniforms.block("Frame", FrameUniforms.BINDING);
            uniforms.sampler("fresh", TextureUnit.SPREAD_FRESH);
            uniforms.sampler("freshPlaces", TextureUnit.SPREAD_PLACES);
            uniforms.sampler("before", TextureUnit.SPREAD_BEFORE);
            return new Places(
                    uniforms.vector2("layerStep"),
                    uniforms.vector3("square"),
                    uniforms.vector3("beforeRight"),
                    uniforms.vector3("beforeUp"),
                    uniforms.vector3("beforeForward"),
                    uniforms.vector3("moved"),
                    uniforms.vector2("halfLayer"),
                    uniforms.scalar("nearestKilometres"),
                    uniforms.vector3("movedPast"));
        }
    }

    /** The marched ray of each square of rays. */
    record Square(int side, int column, int row) {}

    SpreadProgram(LoadContext context) {
        var defines = Defines.of(context).values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "cloud.vert", defines),
                ShaderSource.load(FOLDER + "spread.frag", defines),
                Places::of);
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
        places.step().set((float) (2 / across), (float) (2 / upwards));
        places.square().set(square.side(), square.column(), square.row());
        places.passed()
                .set(
                        (float) (now.eyeX() - before.eyeX() - nearestBlown.x()),
                        (float) (now.eyeY() - before.eyeY() - nearestBlown.y()),
                        (float) (now.eyeZ() - before.eyeZ() - nearestBlown.z()));
        places.nearest().set((float) Math.max(NEAREST_KILOMETRES, Math.min(SKY_KILOMETRES, nearestMetres / 1000)));
        places.half().set((float) (across / 2), (float) (upwards / 2));
        set(places.right(), before.right(), 1 / before.projection().tanHalfWidth());
        set(places.up(), before.up(), 1 / before.projection().tanHalfHeight());
        set(places.forward(), before.back(), -1);
        places.moved().set((float) (now.eyeX() - before.eyeX()), (float) (now.eyeY() - before.eyeY()), (float)
                (now.eyeZ() - before.eyeZ()));
    }

    private static void set(Uniforms.Vector3 place, Vec3 v, double factor) {
        place.set((float) (factor * v.x()), (float) (factor * v.y()), (float) (factor * v.z()));
    }
}
