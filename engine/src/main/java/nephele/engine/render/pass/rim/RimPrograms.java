package nephele.engine.render.pass.rim;

import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/** The programs of a rim's parts; all have the same uniforms. */
final class RimPrograms {
    private static final String FOLDER = "/nephele/engine/render/pass/rim/";

    private static final double OPACITY_OVER_WALL = 0.93;

    private final GlProgram<Placing> ring;
    private final GlProgram<Placing> glow;
    private final GlProgram<Placing> membrane;

    RimPrograms(LoadContext context) {
        ring = program(context, "ring.frag", Defines.of(context));
        glow = program(context, "glow.frag", Defines.of(context));
        membrane = program(context, "membrane.frag", Defines.of(context).with("OPACITY", OPACITY_OVER_WALL));
    }

    private static GlProgram<Placing> program(LoadContext context, String fragment, Defines names) {
        Map<String, String> defines = names.values();
        return new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "rim.vert", defines),
                ShaderSource.load(FOLDER + fragment, defines),
                uniforms -> {
                    MeteredExposure.tieInView(context, uniforms);
                    return new Placing(uniforms);
                });
    }

    GlProgram<Placing> ring() {
        return ring;
    }

    GlProgram<Placing> glow() {
        return glow;
    }

    GlProgram<Placing> membrane() {
        return membrane;
    }

    /** The uniforms for the pose and appearance of one portal. */
    static final class Placing {
        private final Uniforms.Vector4 centre;
        private final Uniforms.Vector3 right;
        private final Uniforms.Vector3 up;
        private final Uniforms.Vector3 back;
        private final Uniforms.Vector4 tint;
        private final Uniforms.Vector4 pattern;

        private Placing(Uniforms uniforms) {
            centre = uniforms.vector4("centreAndOpenness");
            right = uniforms.vector3("portalRight");
            up = uniforms.vector3("portalUp");
            back = uniforms.vector3("portalBack");
            tint = uniforms.vector4("tintAndOpacity");
            pattern = uniforms.vector4("pattern");
        }

        void set(RimLook look) {
            centre.set(
                    (float) (look.centre.x() - look.view.eyeX()),
                    (float) (look.centre.y() - look.view.eyeY()),
                    (float) (look.centre.z() - look.view.eyeZ()),
                    (float) look.openness);
            set(right, look.frame.right());
            set(up, look.frame.up());
            set(back, look.frame.back());
            tint.set((float) look.tint.x(), (float) look.tint.y(), (float) look.tint.z(), (float) look.opacity);
            pattern.set(look.kind, look.cells, (float) look.seconds, (float) look.halfMetres);
        }

        private static void set(Uniforms.Vector3 uniform, Vec3 v) {
            uniform.set((float) v.x(), (float) v.y(), (float) v.z());
        }
    }
}
