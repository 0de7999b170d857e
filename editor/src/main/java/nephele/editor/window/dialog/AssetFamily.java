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
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import nephele.editor.terrain.PaintedAssets;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;

/** Kinds of files that levels name, by the endings of their names. */
enum AssetFamily {
    PICTURE(Set.of("png", "jpg", "jpeg", "tga", "bmp")),
    MODEL(Set.of("3d", "obj", "gltf", "glb")),
    VOLUME(Set.of("vol")),
    /** Raw heights; a terrain's heights may also be a picture. */
    HEIGHTS(Set.of("r16")),
    ANY(Set.of());

    private static final int MOST_DEPTH = 6;
    private static final int MOST_FILES = 5_000;

    private final Set<String> endings;

    AssetFamily(Set<String> endings) {
        this.endings = endings;
    }

    /** Returns the family of a file; {@link #ANY} if levels name no such files. */
    static AssetFamily of(String file) {
        String ending = file.substring(file.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        for (AssetFamily family : values()) {
            if (family.endings.contains(ending)) {
                return family;
            }
        }
        return ANY;
    }

    /** Returns the family that a component names: by its own name, or else as its value does now. */
    static AssetFamily of(String component, String current) {
        String name = component.toLowerCase(Locale.ROOT);
        if (name.equals("heightmap")) {
            return HEIGHTS;
        }
        boolean isPicture =
                name.endsWith("texture") || name.endsWith("map") || name.equals("sprite") || name.equals("files");
        return isPicture ? PICTURE : of(current);
    }

    /** Returns true if a component of this family can name a file. */
    boolean accepts(String file) {
        AssetFamily own = of(file);
        return own != ANY && (this == ANY || this == own || this == HEIGHTS && own == PICTURE);
    }

    /** Returns the ids of this family's files, sorted. A folder that cannot be read is left out. */
    List<String> ids(AssetSource assets) {
        Set<String> ids = new TreeSet<>();
        AssetSource files = assets instanceof PaintedAssets painted ? painted.files() : assets;
        if (files instanceof LevelAssets folders) {
            // Each source names the place that a file would have in its folder.
            folders.places("file").stream().map(Path::getParent).forEach(root -> addIds(ids, root));
        }
        return List.copyOf(ids);
    }

    private void addIds(Set<String> ids, Path root) {
        FileVisitor<Path> visitor = new FileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
                boolean isSkipped = !folder.equals(root)
                        && (folder.getFileName().toString().startsWith(".") || folder.endsWith("cache"));
                return isSkipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                String id = root.relativize(file).toString().replace('\\', '/');
                if (accepts(id) && AssetId.rejectionReason(id) == null) {
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
        };
        try {
            Files.walkFileTree(root, EnumSet.noneOf(FileVisitOption.class), MOST_DEPTH, visitor);
        } catch (IOException unreadable) {
            // An unreadable folder offers nothing; other folders do.
        }
    }
}
