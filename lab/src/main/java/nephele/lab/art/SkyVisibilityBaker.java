package nephele.lab.art;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.named.LevelCatalogue;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.light.bake.SkyVisibilityCache;
import nephele.engine.scene.light.bake.SkyVisibilityFile;

/** Bakes the sky visibility of the levels that ship with the game into {@code baked/} beside them. */
public final class SkyVisibilityBaker {
    private SkyVisibilityBaker() {}

    public static void main(String[] folders) throws IOException {
        for (String folder : folders.length > 0 ? folders : new String[] {"levels", "levels/samples"}) {
            bakeFolder(Path.of(folder));
        }
    }

    /** Bakes the files that are missing and deletes those that no level of the folder needs. */
    private static void bakeFolder(Path folder) throws IOException {
        Path baked = folder.resolve(SkyVisibilityCache.SHIPPED);
        Files.createDirectories(baked);
        Set<String> wanted = new TreeSet<>();
        for (Path level : levels(folder)) {
            fileNameFor(level).ifPresent(wanted::add);
            bake(level, baked);
        }
        for (Path file : bakedFiles(baked)) {
            if (!wanted.contains(file.getFileName().toString())) {
                Files.delete(file);
            }
        }
    }

    private static void bake(Path levelFile, Path baked) throws IOException {
        var name = fileNameFor(levelFile);
        if (name.isEmpty() || Files.exists(baked.resolve(name.get()))) {
            return;
        }
        byte[] bytes = SkyVisibilityFile.encode(SkyVisibility.bake(statics(levelFile), done -> {}));
        Files.write(baked.resolve(name.get()), bytes);
        System.out.println(levelFile + ": " + bytes.length + " bytes");
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
