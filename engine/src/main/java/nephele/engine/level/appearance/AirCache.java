package nephele.engine.level.appearance;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import nephele.engine.asset.CacheFolder;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirFiles;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.LightFieldFile;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;

/** The light fields of air that is not clear, in a folder. A folder that cannot be written only costs time. */
public final class AirCache implements AirFiles {
    /** Suffices for some fifty kinds of air. */
    private static final long MOST_BYTES = 32 << 20;

    private final CacheFolder folder;

    AirCache(Path path) {
        folder = new CacheFolder(path, LightFieldFile.NAMES, MOST_BYTES);
    }

    /** Returns the tables of an air, found in the user's own cache folder or computed. */
    public static AirTables tables(Air air) {
        return AirTables.of(air, new AirCache(CacheFolder.ofUser()), done -> {});
    }

    /** Returns true if the air of an environment needs no computation of seconds. */
    public static boolean has(Environment environment) {
        return !(environment.sky() instanceof Sky.Atmosphere sky)
                || Daylight.air(sky).equals(Air.CLEAR)
                || AirTables.isKept(Daylight.air(sky), new AirCache(CacheFolder.ofUser()));
    }

    /**
     * Computes what is not in the folder yet, before somebody waits without seeing the progress.
     *
     * @param progress of a computation, 0–1; not called without one
     */
    public static void prepare(Environment environment, DoubleConsumer progress) {
        if (environment.sky() instanceof Sky.Atmosphere sky
                && !Daylight.air(sky).isClear()) {
            AirTables.of(Daylight.air(sky), new AirCache(CacheFolder.ofUser()), progress);
        }
    }

    @Override
    public Optional<byte[]> find(String name) {
        return folder.find(name);
    }

    @Override
    public void store(String name, byte[] bytes) {
        try {
            folder.store(name, bytes);
        } catch (IOException e) {
            // The field is computed again the next time.
            return;
        }
    }
}
