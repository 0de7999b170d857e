package nephele.engine.render.frame;

import java.util.concurrent.CompletableFuture;
import nephele.engine.atmosphere.AerialTable;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** An {@link AerialTable} as a texture, which follows the sun. */
final class AerialTexture implements GlObject {
    private final double heightMetres;
    private final Texture texture;
    private AerialTable shown;
    private CompletableFuture<AerialTable> coming;

    AerialTexture(GlContext gl, double heightMetres) {
        this.heightMetres = heightMetres;
        var extent = new Texture.Extent(AerialTable.AZIMUTHS, AerialTable.ROWS, AerialTable.SLICES);
        texture =
                new Texture(gl, "air table", Texture.Shape.VOLUME, PixelFormat.RGBA32F, extent, Sampling.LINEAR_CLAMP);
    }

    double heightMetres() {
        return heightMetres;
    }

    AerialTable table() {
        return shown;
    }

    void bind(TextureUnit unit) {
        texture.bind(unit);
    }

    /** The first table is waited for; while the sun moves, the next one is computed beside the frames. */
    void follow(AirTables tables, double sunSine, boolean moves) {
        if (coming != null && coming.isDone()) {
            show(coming.join());
            coming = null;
        }
        if (coming != null || shown != null && shown.sunSine() == sunSine) {
            return;
        }
        if (shown == null || !moves) {
            show(new AerialTable(tables, heightMetres, sunSine));
        } else {
            coming = CompletableFuture.supplyAsync(() -> new AerialTable(tables, heightMetres, sunSine));
        }
    }

    private void show(AerialTable table) {
        shown = table;
        var texels = MemoryUtil.memAlloc(4 * Float.BYTES * AerialTable.AZIMUTHS * AerialTable.ROWS);
        for (int slice = 0; slice < AerialTable.SLICES; slice++) {
            table.putTexels(slice, texels.asFloatBuffer());
            texture.upload(slice, texels);
        }
        MemoryUtil.memFree(texels);
    }

    @Override
    public void close() {
        texture.close();
    }
}
