package nephele.engine.render.frame;

import nephele.engine.math.Vec3;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.TextureUnit;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.light.LampTable;

/** The lamps' part of {@code surface-light.glsl}, with the shadows of what never moves. */
final class LampLight implements GlObject {
    private final Vec3 anchor;
    private final boolean shadow;
    private final LampTable table;
    private final BufferTexture texels;
    private final BufferTexture grid;

    /**
     * @param table of the level's lamps, or {@code null}
     * @param anchor what positions in shaders are relative to
     */
    LampLight(GlContext gl, FrameRequest request, LampTable table, Vec3 anchor) {
        this.anchor = anchor;
        this.table = table;
        shadow = request.lightMaps().has(Target.LAMP_SHADOW);
        texels = table == null ? null : BufferTexture.ofFloats(gl, "lamps", table.packed(anchor));
        grid = table == null ? null : grid(gl);
    }

    private BufferTexture grid(GlContext gl) {
        try {
            return BufferTexture.ofIntegers(gl, "lamp grid", table.packedGrid());
        } catch (RuntimeException e) {
            texels.close();
            throw e;
        }
    }

    /** {@code null} without lamps. */
    LampTable table() {
        return table;
    }

    Defines addTo(Defines defines) {
        return defines.withIf(table != null, "LAMPS").withIf(shadow, "LAMP_SHADOW");
    }

    void put(LightBlock block) {
        if (table != null) {
            block.lampGrid(table.grid(), anchor);
        }
    }

    void tie(Uniforms uniforms) {
        if (table != null) {
            uniforms.sampler("lampTexels", TextureUnit.LAMPS);
            uniforms.sampler("lampGridCells", TextureUnit.LAMP_GRID);
        }
        if (shadow) {
            uniforms.sampler("lampShadowMaps", TextureUnit.LAMP_SHADOW);
        }
    }

    /** Binds the lists of lamps; their depth pictures are {@link LightMaps}. */
    void bind() {
        if (table != null) {
            texels.bind(TextureUnit.LAMPS);
            grid.bind(TextureUnit.LAMP_GRID);
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
