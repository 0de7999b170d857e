package nephele.engine.render.pass.sky;

import java.nio.FloatBuffer;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.appearance.Moonlight;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.BackgroundWork;
import nephele.engine.render.resource.MovingTable;

/** The {@link SkyTable}s of sun and moon for a height as a texture. */
final class SkyTextures implements GlObject {
    private static final int LAYER_NUMBERS = 4 * SkyTable.AZIMUTHS * SkyTable.ROWS;

    private final double heightMetres;
    private final Texture texture;
    private final MovingTable sun;
    private final MovingTable moon;

    SkyTextures(GlContext gl, BackgroundWork background, AirTables tables, double heightMetres) {
        this.heightMetres = heightMetres;
        texture = new Texture(
                gl,
                "sky table",
                Texture.Shape.ARRAY,
                PixelFormat.RGBA32F,
                new Texture.Extent(SkyTable.AZIMUTHS, SkyTable.ROWS, 2 * SkyTable.PARTS),
                Sampling.LINEAR_CLAMP);
        sun = new MovingTable(
                texture, 0, SkyTable.PARTS, background, sine -> texels(new SkyTable(tables, heightMetres, sine)));
        moon = new MovingTable(
                texture,
                SkyTable.PARTS,
                SkyTable.PARTS,
                background,
                sine -> texels(new SkyTable(tables, heightMetres, sine)));
    }

    private static float[] texels(SkyTable table) {
        float[] texels = new float[LAYER_NUMBERS * SkyTable.PARTS];
        for (int part = 0; part < SkyTable.PARTS; part++) {
            table.putTexels(part, FloatBuffer.wrap(texels, part * LAYER_NUMBERS, LAYER_NUMBERS));
        }
        return texels;
    }

    /** Returns true if no table of sun or moon has to be waited for. */
    boolean isReady(Vec3 towardsSun, Moonlight moonlight, boolean isMoving) {
        boolean isSunReady = sun.isReady(towardsSun.y(), isMoving);
        return isSunReady
                && (!moonlight.shines() || moon.isReady(moonlight.towardsMoon().y(), isMoving));
    }

    /** Computes the tables that are missing beside the frames. */
    void prepare(Vec3 towardsSun, Moonlight moonlight) {
        sun.prepare(towardsSun.y());
        if (moonlight.shines()) {
            moon.prepare(moonlight.towardsMoon().y());
        }
    }

    /** Returns the height of the eye for which the tables are. */
    double heightMetres() {
        return heightMetres;
    }

    void bind(TextureUnit unit) {
        texture.bind(unit);
    }

    MovingTable sun() {
        return sun;
    }

    MovingTable moon() {
        return moon;
    }

    @Override
    public void close() {
        texture.close();
    }
}
