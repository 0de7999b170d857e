package nephele.lab.bake;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.DoubleConsumer;
import java.util.stream.Stream;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.LightCache;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.light.bake.SkyVisibilityFile;
import nephele.host.named.LevelCatalogue;

/** Bakes the sky visibility of a level into {@code baked/} beside it, where a level that ships has it. */
public final class SkyVisibilityBaker {
    private SkyVisibilityBaker() {}

    /**
     * Bakes the level's file if it is missing, and deletes files that no level of the folder needs.
     *
     * @param progress receives the completed fraction, 0–1
     * @return lines that tell what was done
     */
    public static List<String> bake(Path levelFile, DoubleConsumer progress) throws IOException {
        Path folder = levelFile.toAbsolutePath().getParent();
        Path baked = folder.resolve(LightCache.SHIPPED);
        Optional<String> name = fileNameFor(levelFile);
        List<String> reported = new ArrayList<>();
        if (name.isEmpty()) {
            reported.add(levelFile + ": no sky lights its surfaces; there is nothing to bake");
        } else if (Files.exists(baked.resolve(name.get()))) {
            reported.add(levelFile + ": its light is baked already");
        } else {
            byte[] bytes = SkyVisibilityFile.encode(SkyVisibility.bake(statics(levelFile), progress));
            AtomicFile.write(baked.resolve(name.get()), bytes);
            reported.add(baked.resolve(name.get()) + ": " + bytes.length + " bytes");
        }
        reported.addAll(prune(folder, baked));
        return reported;
    }

    private static List<String> prune(Path folder, Path baked) throws IOException {
        Set<String> wanted = new TreeSet<>();
        try {
            for (Path level : levels(folder)) {
                fileNameFor(level).ifPresent(wanted::add);
            }
        } catch (LevelFormatException | AssetException unreadable) {
            // What such a level needs is not known, so nothing is deleted.
            return List.of();
        }
        List<String> reported = new ArrayList<>();
        for (Path file : Files.isDirectory(baked) ? bakedFiles(baked) : List.<Path>of()) {
            if (!wanted.contains(file.getFileName().toString())) {
                Files.delete(file);
                reported.add(file + ": deleted, no level of the folder needs it");
            }
        }
        return reported;
    }

    /** Returns the name of the baked file of a level; empty if no sky lights the level. */
    public static Optional<String> fileNameFor(Path levelFile) throws IOException {
        return LightRequirements.skyVisibility(read(levelFile))
                ? Optional.of(SkyVisibilityFile.nameFor(statics(levelFile)))
                : Optional.empty();
    }

    private static Level read(Path levelFile) throws IOException {
        return LevelJson.read(levelFile.toString(), Files.readAllBytes(levelFile));
    }

    private static StaticShapes statics(Path levelFile) throws IOException {
        return StaticShapes.of(read(levelFile), LevelAssets.beside(levelFile)).split(SkyVisibility.MODEL_EDGE_METRES);
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
