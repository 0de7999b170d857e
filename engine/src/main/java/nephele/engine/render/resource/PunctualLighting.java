package nephele.engine.render.resource;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.LightMaps;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.light.PunctualLightTable;

/** The punctual lights' part of {@code surface-light.glsl}, with the shadows of static geometry. */
final class PunctualLighting implements GlObject {
    private final Vec3 anchor;
    private final boolean shadow;
    private final PunctualLightTable table;
    private final BufferTexture texels;
    private final BufferTexture grid;

    /**
     * @param table the level's lights, or {@code null}; the weaker ones lose their shadows, as quality decides
     * @param anchor the origin of positions in shaders
     */
    PunctualLighting(GlContext gl, FrameRequest request, PunctualLightTable table, Vec3 anchor) {
        this.anchor = anchor;
        int casting = request.quality().lightShadows();
        this.table = table == null ? null : table.withMostShadows(casting);
        shadow = request.lightMaps().has(Target.LIGHT_SHADOW);
        texels = table == null ? null : BufferTexture.ofFloats(gl, "punctual lights", this.table.packed(anchor));
        grid = table == null ? null : grid(gl);
    }

    private BufferTexture grid(GlContext gl) {
        try {
            return BufferTexture.ofIntegers(gl, "light grid", table.packedGrid());
        } catch (RuntimeException e) {
            texels.close();
            throw e;
        }
    }

    /** Returns {@code null} without punctual lights. */
    PunctualLightTable table() {
        return table;
    }

    Defines addTo(Defines defines) {
        return defines.withIf(table != null, "PUNCTUAL_LIGHTS").withIf(shadow, "LIGHT_SHADOW");
    }

    void put(LightBlock block) {
        if (table != null) {
            block.lightGrid(table.grid(), anchor);
        }
    }

    void tie(Uniforms uniforms) {
        if (table != null) {
            uniforms.sampler("lightTexels", TextureUnit.PUNCTUAL_LIGHTS);
            uniforms.sampler("lightGridCells", TextureUnit.LIGHT_GRID);
        }
        if (shadow) {
            uniforms.sampler("lightShadowMaps", TextureUnit.LIGHT_SHADOW);
        }
    }

    /** Binds the light lists; {@link LightMaps} binds the depth pictures. */
    void bind() {
        if (table != null) {
            texels.bind(TextureUnit.PUNCTUAL_LIGHTS);
            grid.bind(TextureUnit.LIGHT_GRID);
        }
    }

    @Override
    public void close() {
        if (table != null) {
            texels.close();
            grid.close();
        }
    }
}
