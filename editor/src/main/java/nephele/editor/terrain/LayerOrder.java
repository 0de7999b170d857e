package nephele.editor.terrain;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.record.ListEdit;
import nephele.editor.text.EditorRefusal;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;

/** Lets paint follow its layers: layer maps name layers by their index, and edits of a list of layers change indices. */
public final class LayerOrder {
    private LayerOrder() {}

    /**
     * Returns a level with new layer maps for the terrains whose layers an edit has changed. Paint of a layer that is gone
     * is erased; a map that cannot be read, or that looks the same, stays.
     *
     * @param before the edit
     * @param after the edit of the lists of layers, with the terrains in the same order
     * @throws EditorRefusal if a new map cannot be kept
     */
    public static Level followed(Level before, Level after, ListEdit edit, AssetSource assets, PaintedMaps maps)
            throws EditorRefusal {
        List<Terrain> terrains = new ArrayList<>();
        boolean differs = false;
        for (int i = 0; i < after.terrains().size(); i++) {
            Terrain authored = after.terrains().get(i);
            boolean isEdited =
                    !authored.layers().equals(before.terrains().get(i).layers());
            Terrain followed =
                    isEdited && authored.layerMap() != null ? followed(authored, edit, assets, maps) : authored;
            differs |= followed != authored;
            terrains.add(followed);
        }
        return differs ? after.withTerrains(List.copyOf(terrains)) : after;
    }

    private static Terrain followed(Terrain authored, ListEdit edit, AssetSource assets, PaintedMaps maps)
            throws EditorRefusal {
        LayerMap map;
        try {
            map = assets.decoded(authored.layerMap(), LayerMap.class, LayerMap::read);
        } catch (AssetException unusable) {
            return authored;
        }
        LayerMap renumbered = renumbered(map, edit);
        if (renumbered == map) {
            return authored;
        }
        if (!maps.canKeep()) {
            throw new EditorRefusal(TerrainText.SAVE_FIRST.words());
        }
        try {
            return authored.withLayerMap(
                    maps.keep(LayerStroke.fileName(authored), PaintedMaps.PaintedMap.of(renumbered)));
        } catch (IOException problem) {
            throw new EditorRefusal(TerrainText.NOT_KEPT.with(problem.getMessage()));
        }
    }

    /** Returns a map whose texels name the layers after an edit; the same object if none differs. */
    static LayerMap renumbered(LayerMap map, ListEdit edit) {
        byte[] texels = map.texels().clone();
        boolean differs = false;
        for (int at = 0; at < texels.length; at += LayerMap.TEXEL_BYTES) {
            int layer = texels[at] & 0xff;
            int next = edit.after(layer);
            if (texels[at + 1] == 0 || next == layer) {
                continue;
            }
            differs = true;
            texels[at] = (byte) Math.max(next, 0);
            texels[at + 1] = next == ListEdit.NONE ? 0 : texels[at + 1];
        }
        return differs ? new LayerMap(map.columns(), map.rows(), texels) : map;
    }
}
