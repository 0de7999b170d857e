package nephele.editor.terrain;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.engine.level.Terrain;

/** The layers that the brush of terrains can paint, named by their materials. */
public final class LayerChoice {
    private LayerChoice() {}

    /** Returns the layers of the first selected terrain, without one those of the first terrain that has layers to choose from. */
    public static List<String> names(Snapshot now) {
        Selection selection = now.selection();
        List<Terrain> terrains = now.level().terrains();
        Optional<Terrain> selected = terrains.stream()
                .filter(terrain -> selection.entities().stream()
                        .anyMatch(ref ->
                                ref.section().equals("terrains") && ref.id().equals(terrain.id())))
                .findFirst();
        return selected.or(() -> terrains.stream()
                        .filter(terrain -> terrain.layers().size() > 1)
                        .findFirst())
                .map(LayerChoice::names)
                .orElse(List.of());
    }

    /** Returns the layers of a terrain. */
    public static List<String> names(Terrain authored) {
        return authored.layers().stream().map(Terrain.Layer::material).toList();
    }

    /** Returns the name of a layer, its index if the terrain has none of it. */
    public static String name(Terrain authored, int layer) {
        List<String> names = names(authored);
        return layer < names.size() ? names.get(layer) : String.valueOf(layer);
    }

    /** Returns the layer that a text names by its index or its material; empty without one. */
    public static OptionalInt index(List<String> names, String text) {
        int named = names.indexOf(text);
        if (named < 0 && text.matches("\\d")) {
            named = Integer.parseInt(text);
        }
        return named >= 0 && named < names.size() ? OptionalInt.of(named) : OptionalInt.empty();
    }
}
