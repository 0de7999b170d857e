package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import nephele.engine.atmosphere.AerialTable;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;

/** An {@link AerialTable} as a texture, which follows the sun. */
public final class AerialTexture implements GlObject {
    private static final int SLICE_NUMBERS = 4 * AerialTable.AZIMUTHS * AerialTable.ROWS;

    private final double heightMetres;
    private final Texture texture;
    private final MovingTable sun;

    public AerialTexture(GlContext gl, BackgroundWork background, AirTables tables, double heightMetres) {
        this.heightMetres = heightMetres;
        var extent = new Texture.Extent(AerialTable.AZIMUTHS, AerialTable.ROWS, AerialTable.SLICES);
        texture =
                new Texture(gl, "air table", Texture.Shape.VOLUME, PixelFormat.RGBA32F, extent, Sampling.LINEAR_CLAMP);
        sun = new MovingTable(
                texture,
                0,
                AerialTable.SLICES,
                background,
                sine -> texels(new AerialTable(tables, heightMetres, sine)));
    }

    private static float[] texels(AerialTable table) {
        float[] texels = new float[SLICE_NUMBERS * AerialTable.SLICES];
        for (int slice = 0; slice < AerialTable.SLICES; slice++) {
            table.putTexels(slice, FloatBuffer.wrap(texels, slice * SLICE_NUMBERS, SLICE_NUMBERS));
        }
        return texels;
    }

    public double heightMetres() {
        return heightMetres;
    }

    public void bind(TextureUnit unit) {
        texture.bind(unit);
    }

    /** Returns what follows the sun. */
    public MovingTable sun() {
        return sun;
    }

    @Override
    public void close() {
        texture.close();
    }
}
