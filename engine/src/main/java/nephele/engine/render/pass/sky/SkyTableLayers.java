package nephele.engine.render.pass.sky;

import java.nio.FloatBuffer;
import java.util.concurrent.CompletableFuture;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.render.gl.Texture;
import org.lwjgl.system.MemoryUtil;

/**
 * The {@link SkyTable} of sun or moon in its layers of a texture. The first one is waited for; while the light moves, the
 * next one is made beside the frames.
 */
final class SkyTableLayers {
    private final Texture texture;
    private final int firstLayer;
    private Key shown;
    private CompletableFuture<Made> coming;

    /** The arguments of a table. */
    private record Key(AirTables tables, double heightMetres, double sine) {}

    private record Made(Key key, SkyTable table) {}

    SkyTableLayers(Texture texture, int firstLayer) {
        this.texture = texture;
        this.firstLayer = firstLayer;
    }

    /**
     * Follows the light.
     *
     * @param sine of the light's elevation
     * @param dayLengthSeconds 0 for a light that stands still; its table is waited for
     */
    void follow(AirTables tables, double heightMetres, double sine, double dayLengthSeconds) {
        if (coming != null && coming.isDone()) {
            show(coming.join());
            coming = null;
        }
        boolean isShown =
                shown != null && shown.tables == tables && shown.heightMetres == heightMetres && shown.sine == sine;
        if (isShown || coming != null) {
            return;
        }
        Key wanted = new Key(tables, heightMetres, sine);
        if (shown == null || shown.tables != tables || dayLengthSeconds == 0) {
            show(make(wanted));
        } else {
            coming = CompletableFuture.supplyAsync(() -> make(wanted));
        }
    }

    /** Returns the height of the eye of the table that is shown. */
    double heightMetres() {
        return shown.heightMetres;
    }

    private static Made make(Key key) {
        return new Made(key, new SkyTable(key.tables, key.heightMetres, key.sine));
    }

    private void show(Made made) {
        shown = made.key;
        var texels = MemoryUtil.memAlloc(4 * Float.BYTES * SkyTable.AZIMUTHS * SkyTable.ROWS);
        for (int part = 0; part < SkyTable.PARTS; part++) {
            FloatBuffer numbersOfPart = texels.asFloatBuffer();
            made.table.putTexels(part, numbersOfPart);
            texture.upload(firstLayer + part, texels);
        }
        MemoryUtil.memFree(texels);
    }
}
