package nephele.editor.window;

import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JComboBox;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.terrain.LayerChoice;
import nephele.editor.terrain.TerrainBrush;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.widget.WordCell;

/** The choice of the layer that the terrain tool paints; a choice also begins painting. */
final class LayerBox extends JComboBox<Integer> {
    private static final long serialVersionUID = 1;

    private final transient EditorSession session;
    private transient List<String> names = List.of();
    private boolean isFilling;

    LayerBox(EditorSession session) {
        this.session = session;
        setName("terrain-layers");
        setRenderer(new WordCell<Integer>(layer -> layer < names.size() ? names.get(layer) : ""));
        addActionListener(event -> choose());
    }

    /** Returns true if the tool in use and the level leave something to choose. */
    static boolean isOffered(EditorSession session) {
        return session.toolEntry().id().equals("terrain")
                && LayerChoice.names(session.document().now()).size() > 1;
    }

    private void choose() {
        TerrainBrush before = session.options().terrainBrush();
        if (!isFilling && getSelectedItem() instanceof Integer layer) {
            session.options().terrainBrush(before.ofLayer(layer).with(Effect.PAINT));
            session.tell(SessionChange.VIEW);
        }
    }

    /** Shows the layers of now, and which one is chosen; nothing if the terrain has not that many. */
    void refresh() {
        List<String> now = LayerChoice.names(session.document().now());
        int chosen = session.options().terrainBrush().layer();
        isFilling = true;
        if (!now.equals(names)) {
            names = now;
            removeAllItems();
            IntStream.range(0, now.size()).forEach(this::addItem);
            revalidate();
        }
        setSelectedIndex(chosen < now.size() ? chosen : -1);
        isFilling = false;
    }
}
