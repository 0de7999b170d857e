package nephele.editor.window.dialog;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.Icon;
import nephele.editor.panel.AssetChooser;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.session.EditorSession;
import nephele.editor.widget.AssetPictures;

/** Lets the user choose one of the files that the level can name, with small pictures of the textures. */
public final class AssetDialog implements AssetChooser {
    private static final int ROW_POINTS = 44;
    private static final int ICON_POINTS = 36;
    private static final int SMALL_POINTS = 16;

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
        List<String> all = family.ids(session.assets());
        int rowPoints = family == AssetFamily.PICTURE ? ROW_POINTS : ROW_POINTS / 2 + 2;
        return new SearchList<>(
                DialogText.SEARCH_FILES,
                query -> all.stream().filter(id -> Searches.hasWords(query, id)).toList(),
                id -> row(id, rowPoints),
                done,
                session.language(),
                rowPoints);
    }

    private SearchList.Row row(String id, int rowPoints) {
        int slash = id.lastIndexOf('/');
        Icon icon = AssetFamily.of(id) == AssetFamily.PICTURE
                ? pictures.icon(id, rowPoints == ROW_POINTS ? ICON_POINTS : SMALL_POINTS)
                : null;
        return new SearchList.Row(id.substring(slash + 1), slash < 0 ? "" : id.substring(0, slash), "", icon, true);
    }

    @Override
    public Optional<Icon> picture(String assetId) {
        boolean isPicture = AssetFamily.of(assetId) == AssetFamily.PICTURE;
        return isPicture ? Optional.of(pictures.icon(assetId, SMALL_POINTS)) : Optional.empty();
    }
}
