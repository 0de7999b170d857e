package nephele.lab.bake;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.bake.LightBake;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.StoredLight;
import nephele.engine.scene.light.bake.LightCache;
import nephele.engine.scene.light.bake.LightKey;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.light.bake.SkyVisibilityFile;
import nephele.host.named.LevelCatalogue;
import nephele.host.terminal.PrintedProgress;

/**
 * Bakes the light of a level into {@code baked/} beside it, where a level that ships has it: the sky visibility, and all
 * light that does not change. A coarse version of this is there after a tenth of the time; an interrupted bake goes on.
 */
public final class LightBaker {
    private final Path levelFile;
    private final Path folder;
    private final PrintStream log;
    private final PlacedLevel placed;
    private final List<String> reported = new ArrayList<>();

    private LightBaker(Path levelFile, PrintStream log) throws IOException {
        this.levelFile = levelFile;
        this.log = log;
        folder = folder(levelFile);
        placed = placed(levelFile);
    }

    private static Path folder(Path levelFile) {
        return levelFile.toAbsolutePath().resolveSibling(LightCache.SHIPPED);
    }

    /**
     * Bakes what is missing, and deletes files that no level of the folder needs.
     *
     * @param settings {@code null} for the usual ones, with which light that is there is not baked again
     * @param log receives progress
     * @return lines that tell what was done
     */
    public static List<String> bake(Path levelFile, LightBake.Settings settings, PrintStream log) throws IOException {
        LightBaker baker = new LightBaker(levelFile, log);
        if (!LightRequirements.hasSurfaces(baker.placed.level())) {
            baker.reported.add(levelFile + ": it has no surfaces; there is nothing to bake");
            return baker.reported;
        }
        baker.bakeVisibility();
        try {
            baker.bakeLight(settings);
        } catch (UncheckedIOException unwritten) {
            throw unwritten.getCause();
        }
        baker.prune();
        return baker.reported;
    }

    private void bakeVisibility() throws IOException {
        Path file = visibilityName(placed).map(folder::resolve).orElse(null);
        if (file != null && !Files.exists(file)) {
            SkyVisibility visibility =
                    SkyVisibility.bake(LevelLight.baked(placed), PrintedProgress.of(log, "baking the sky visibility"));
            write(file, SkyVisibilityFile.encode(visibility), "");
        }
    }

    private void write(Path file, byte[] bytes, String facts) throws IOException {
        AtomicFile.write(file, bytes);
        reported.add(String.format(Locale.ROOT, "%s: %s%,d bytes", file, facts, bytes.length));
    }

    private void bakeLight(LightBake.Settings settings) throws IOException {
        Path file = folder.resolve(LightKey.of(placed).fileName());
        Path part = part(levelFile);
        boolean isDone = settings == null
                && !Files.exists(part)
                && Files.exists(file)
                && LevelLight.stored(placed).state() == StoredLight.State.BAKED;
        if (isDone) {
            reported.add(levelFile + ": its light is baked already");
            return;
        }
        long start = System.nanoTime();
        AirCache.prepare(placed.level().environment(), PrintedProgress.of(log, "working out the air"));
        LightBake.Settings used = settings == null ? LightBake.Settings.USUAL : settings;
        LightBake bake = LightBake.of(placed, used);
        try (LightCheckpoint checkpoint = LightCheckpoint.open(part, facts(placed, used), bake.blocks())) {
            bake.balance(PrintedProgress.of(log, "balancing the light"));
            double before = (double) checkpoint.found() / bake.blocks();
            if (before > 0) {
                log.println("resumed at " + (int) (100 * before) + " %");
            } else {
                AtomicFile.write(file, StoredLight.file(placed, bake.light()));
            }
            bake.gather(checkpoint, PrintedProgress.of(log, "gathering the light", before));
            LightBake.Error error = bake.error();
            String found = String.format(
                    Locale.ROOT,
                    "light at %,d points, standard error %.2g %% (median), %.2g %% (99 of 100), %.0f s, ",
                    bake.receivers(),
                    100 * error.median(),
                    100 * error.percentile99(),
                    (System.nanoTime() - start) / 1e9);
            write(file, StoredLight.file(placed, bake.light()), found);
            checkpoint.forget();
        }
    }

    /** Returns the file of a bake that is not finished. */
    static Path part(Path levelFile) {
        return folder(levelFile).resolve(levelFile.getFileName() + ".light.part");
    }

    /** Returns what the blocks of a bake depend on. */
    static String facts(PlacedLevel placed, LightBake.Settings settings) {
        return StoredLight.contentName(placed) + " " + settings;
    }

    private void prune() throws IOException {
        Set<String> wanted = new TreeSet<>();
        try {
            for (Path level : levels(levelFile.toAbsolutePath().getParent())) {
                PlacedLevel kept = placed(level);
                visibilityName(kept).ifPresent(wanted::add);
                wanted.add(LightKey.of(kept).fileName());
            }
        } catch (LevelFormatException | AssetException unreadable) {
            // What such a level needs is not known, so nothing is deleted.
            return;
        }
        for (Path file : Files.isDirectory(folder) ? bakedFiles(folder) : List.<Path>of()) {
            if (!wanted.contains(file.getFileName().toString())) {
                Files.delete(file);
                reported.add(file + ": deleted, no level of the folder needs it");
            }
        }
    }

    /** Returns the name of the sky visibility of a level; empty if no sky lights the level. */
    public static Optional<String> fileNameFor(Path levelFile) throws IOException {
        return visibilityName(placed(levelFile));
    }

    private static Optional<String> visibilityName(PlacedLevel placed) {
        return LevelLight.isRequired(placed)
                ? Optional.of(SkyVisibilityFile.nameFor(LevelLight.baked(placed)))
                : Optional.empty();
    }

    private static PlacedLevel placed(Path levelFile) throws IOException {
        var level = LevelJson.read(levelFile.toString(), Files.readAllBytes(levelFile));
        return PlacedLevel.of(level, LevelAssets.beside(levelFile));
    }

    /** Returns the levels in a folder, sorted. */
    public static List<Path> levels(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(LevelCatalogue::isLevel).sorted().toList();
        }
    }

    private static List<Path> bakedFiles(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(file -> file.toString().endsWith(".bin")).sorted().toList();
        }
    }
}
