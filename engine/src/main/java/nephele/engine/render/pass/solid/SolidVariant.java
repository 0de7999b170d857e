package nephele.engine.render.pass.solid;

import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.ShaderSource;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.SolidBatch;

/**
 * Which code a batch's shader holds; equal variants share a program.
 *
 * @param emission whether any material shines
 */
record SolidVariant(boolean lambert, boolean textured, boolean normalMapped, boolean emission) {
    static final int COLOUR_UNIT = 0;

    private static final String FOLDER = "/nephele/engine/render/pass/solid/";

    static SolidVariant of(SolidBatch.Kind kind, Level level) {
        boolean emission =
                level.materials().stream().anyMatch(m -> !m.emission().equals(Vec3.ZERO));
        return new SolidVariant(kind.lambert(), kind.isTextured(), kind.isNormalMapped(), emission);
    }

    GlProgram<SolidUniforms> program(LoadContext context, int materialsPerBlock) {
        var defines = defines(context).with("MATERIAL_COUNT", materialsPerBlock).values();
        return new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "solid.vert", defines),
                ShaderSource.load(FOLDER + "solid.frag", defines),
                uniforms -> uniforms(uniforms, context.scene().level().environment()));
    }

    private Defines defines(LoadContext context) {
        Environment environment = context.scene().level().environment();
        return Defines.of(context)
                .with(lambert ? "LAMBERT" : "METALLIC_ROUGHNESS")
                .withIf(textured, "TEXTURED")
                .withIf(normalMapped, "NORMAL_MAP")
                .withIf(emission, "EMISSION")
                .withIf(environment.sun() != null, "SUN")
                .withIf(environment.ambient() != null, "AMBIENT_CONSTANT")
                .withIf(isLitPerFace(context.scene().level()), "FLAT_LIGHT");
    }

    /** Where light cannot differ from one point of a face to the next. */
    private boolean isLitPerFace(Level level) {
        return lambert && !normalMapped && level.lights().isEmpty();
    }

    private SolidUniforms uniforms(Uniforms uniforms, Environment environment) {
        uniforms.block("Frame", FrameUniforms.BINDING);
        uniforms.block("Materials", MaterialBlocks.BINDING);
        if (textured) {
            uniforms.sampler("colours", COLOUR_UNIT);
        }
        if (environment.sun() != null) {
            var towards = environment.sun().directionTowardsSun().toVector().normalize();
            uniforms.vector3("sunDirection").set((float) towards.x, (float) towards.y, (float) towards.z);
            set(uniforms.vector3("sunIrradiance"), environment.sun().irradiance());
        }
        if (environment.ambient() != null) {
            set(uniforms.vector3("ambientRadiance"), environment.ambient());
        }
        return new SolidUniforms(uniforms.vector3("eyeHigh"), uniforms.vector3("eyeLow"));
    }

    private static void set(Uniforms.Vector3 uniform, Vec3 v) {
        uniform.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
