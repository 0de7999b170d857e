package nephele.engine.render.pass.solid;

import java.util.Optional;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.MaterialBlocks;
import nephele.engine.render.frame.SurfaceLight;
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
    static final int NORMAL_UNIT = 1;

    private static final String FOLDER = "/nephele/engine/render/pass/solid/";

    static SolidVariant of(SolidBatch.Kind kind, Level level) {
        boolean emission =
                level.materials().stream().anyMatch(m -> !m.emission().equals(Vec3.ZERO));
        return new SolidVariant(kind.lambert(), kind.isTextured(), kind.isNormalMapped(), emission);
    }

    GlProgram<SolidUniforms> program(LoadContext context, int materialsPerBlock) {
        SurfaceLight light = context.shared().surfaceLight(context);
        var defines = defines(context, light)
                .with("MATERIAL_COUNT", materialsPerBlock)
                .values();
        return new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "solid.vert", defines),
                ShaderSource.load(FOLDER + "solid.frag", defines),
                uniforms -> uniforms(uniforms, light));
    }

    private Defines defines(LoadContext context, SurfaceLight light) {
        return light.addTo(Defines.of(context))
                .with(lambert ? "LAMBERT" : "METALLIC_ROUGHNESS")
                .withIf(textured, "TEXTURED")
                .withIf(normalMapped, "NORMAL_MAP")
                .withIf(emission, "EMISSION")
                .withIf(isLitPerFace(light), "FLAT_LIGHT");
    }

    /** Where light cannot differ from one point of a face to the next. */
    private boolean isLitPerFace(SurfaceLight light) {
        return lambert && !normalMapped && !light.variesOverFaces();
    }

    private SolidUniforms uniforms(Uniforms uniforms, SurfaceLight light) {
        uniforms.block("Frame", FrameUniforms.BINDING);
        uniforms.block("Materials", MaterialBlocks.BINDING);
        if (textured) {
            uniforms.sampler("colours", COLOUR_UNIT);
        }
        if (normalMapped) {
            uniforms.sampler("normals", NORMAL_UNIT);
        }
        light.set(uniforms);
        return new SolidUniforms(
                uniforms.vector3("eyeHigh"),
                uniforms.vector3("eyeLow"),
                light.needsPositions() ? Optional.of(uniforms.vector3("cellFromAnchor")) : Optional.empty());
    }
}
