package nephele.engine.render.frame;

import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameUniforms;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.scene.SolidBatch;

/** The variant of the material code in a shader, for solids or dynamic objects. */
public record SurfaceVariant(boolean lambert, boolean textured, boolean normalMapped) {
    public static SurfaceVariant of(SolidBatch.Kind kind) {
        return new SurfaceVariant(kind.lambert(), kind.isTextured(), kind.isNormalMapped());
    }

    /**
     * Adds the defines.
     *
     * @param materialsPerBlock length of the array of materials
     */
    public Defines addTo(Defines defines, int materialsPerBlock) {
        return defines.with("MATERIAL_COUNT", materialsPerBlock)
                .with(lambert ? "LAMBERT" : "METALLIC_ROUGHNESS")
                .withIf(textured, "TEXTURED")
                .withIf(normalMapped, "NORMAL_MAP");
    }

    /** Binds the samplers and blocks of a program compiled with {@link #addTo} permanently. */
    public void set(Uniforms uniforms) {
        uniforms.block("Frame", FrameUniforms.BINDING);
        uniforms.block("Materials", MaterialBlocks.BINDING);
        if (textured) {
            uniforms.sampler("colours", TextureUnit.COLOURS);
        }
        if (normalMapped) {
            uniforms.sampler("normals", TextureUnit.NORMALS);
        }
    }
}
