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
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.Icon;
import nephele.editor.panel.AssetChooser;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.session.EditorSession;
import nephele.editor.terrain.PaintedAssets;
import nephele.editor.widget.AssetPictures;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;

/** Lets the user choose one of the files that the level can name, with small pictures of the textures. */
public final class AssetDialog implements AssetChooser {
    private static final int ROW_POINTS = 44;
    private static final int ICON_POINTS = 36;
    private static final int SMALL_POINTS = 16;
    private static final int MOST_DEPTH = 6;
    private static final int MOST_FILES = 5_000;

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

    private final EditorSession session;
    private final DialogOpener frame;
    private final AssetPictures pictures;

    /**
     * @param frame shows the dialogue
     * @param pictures of the assets of the session
     */
    public AssetDialog(EditorSession session, DialogOpener frame, AssetPictures pictures) {
        this.session = session;
        this.frame = frame;
        this.pictures = pictures;
    }

    @Override
    public Optional<String> choose(InspectorField field, String current) {
        AtomicReference<Optional<String>> chosen = new AtomicReference<>(Optional.empty());
        frame.open(DialogText.CHOOSE_ASSET.in(session.language()), close -> {
            AssetFamily family = AssetFamily.of(field.type().field().name(), current);
            SearchList<String> list = list(family, id -> {
                chosen.set(id);
                close.run();
            });
            return new DialogFrame.Content(list, list.query(), null);
        });
        return chosen.get();
    }

    /** Returns the list of the files of a family. */
    SearchList<String> list(AssetFamily family, Consumer<Optional<String>> done) {
        List<String> all = of(session.assets(), family);
        int rowPoints = family == AssetFamily.PICTURE ? ROW_POINTS : ROW_POINTS / 2 + 2;
        return new SearchList<>(
                new SearchList.Search<>(
                        DialogText.SEARCH_FILES,
                        query -> all.stream()
                                .filter(id -> Searches.hasWords(query, id))
                                .toList(),
                        id -> row(id, rowPoints),
                        done),
                session.language(),
                rowPoints);
    }

    private SearchRow row(String id, int rowPoints) {
        int slash = id.lastIndexOf('/');
        Icon icon = AssetFamily.of(id) == AssetFamily.PICTURE
                ? pictures.icon(id, rowPoints == ROW_POINTS ? ICON_POINTS : SMALL_POINTS)
                : null;
        return new SearchRow(id.substring(slash + 1), slash < 0 ? "" : id.substring(0, slash), "", icon, true);
    }

    @Override
    public Optional<Icon> picture(String assetId) {
        boolean isPicture = AssetFamily.of(assetId) == AssetFamily.PICTURE;
        return isPicture ? Optional.of(pictures.icon(assetId, SMALL_POINTS)) : Optional.empty();
    }

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
}
