package nephele.editor.window.dialog;

import java.io.IOException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.FileVisitor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import nephele.editor.terrain.PaintedAssets;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;

/** The files that a level can name: those in its own folder and in the shared folders of assets. */
final class AssetFiles {
    private static final int MOST_DEPTH = 6;
    private static final int MOST_FILES = 5_000;

    private AssetFiles() {}

    /** Returns the ids of a family, sorted. A folder that cannot be read is left out. */
    static List<String> of(AssetSource assets, AssetFamily family) {
        Set<String> ids = new TreeSet<>();
        AssetSource written = assets instanceof PaintedAssets painted ? painted.files() : assets;
        if (written instanceof LevelAssets files) {
            // Each source names the place that a file would have in its folder.
            files.places("file").stream().map(Path::getParent).forEach(root -> add(ids, root, family));
        }
        return List.copyOf(ids);
    }

    private static void add(Set<String> ids, Path root, AssetFamily family) {
        try {
            Files.walkFileTree(root, EnumSet.noneOf(FileVisitOption.class), MOST_DEPTH, new Visit(ids, root, family));
        } catch (IOException unreadable) {
            // An unreadable folder offers nothing; other folders do.
        }
    }

    private static final class Visit implements FileVisitor<Path> {
        private final Set<String> ids;
        private final Path root;
        private final AssetFamily family;

        Visit(Set<String> ids, Path root, AssetFamily family) {
            this.ids = ids;
            this.root = root;
            this.family = family;
        }

        @Override
        public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            boolean isSkipped = !folder.equals(root)
                    && (folder.getFileName().toString().startsWith(".") || folder.endsWith("cache"));
            return isSkipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
        }

        @Override
        public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            String id = root.relativize(file).toString().replace('\\', '/');
            if (family.accepts(id) && AssetId.rejectionReason(id) == null) {
                ids.add(id);
            }
            return ids.size() < MOST_FILES ? FileVisitResult.CONTINUE : FileVisitResult.TERMINATE;
        }

        @Override
        public FileVisitResult postVisitDirectory(Path folder, IOException problem) {
            return FileVisitResult.CONTINUE;
        }

        @Override
        public FileVisitResult visitFileFailed(Path file, IOException problem) {
            return FileVisitResult.CONTINUE;
        }
    }
}
