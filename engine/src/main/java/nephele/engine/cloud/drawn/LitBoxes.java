package nephele.engine.cloud.drawn;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.cells.LightCells;
import nephele.engine.cloud.light.CloudLight;

/**
 * The light in the boxes of a cloud. That of a box is found again only if this box, a wider one, the sun or a cloud that
 * shades it has changed: a cloud that drifts keeps its light, and so do the wider boxes while the narrowest one moves.
 */
final class LitBoxes {
    private final boolean isLayer;
    private final CloudLight physics;
    private final int kept;
    private final Map<Key, LightCells> lit = new LinkedHashMap<>(16, 0.75f, true);

    /** What the light in a box depends on. @param density in the box and in all wider ones */
    private record Key(List<DensityCells> density, LightCells.Around around) {}

    /** @param kept number of boxes that are remembered */
    LitBoxes(boolean isLayer, CloudLight physics, int kept) {
        this.isLayer = isLayer;
        this.physics = physics;
        this.kept = kept;
    }

    /** Returns the light in boxes, the narrowest first. */
    List<LightCells> of(List<DensityCells> density, LightCells.Around around) {
        List<LightCells> light = new ArrayList<>();
        for (int box = 0; box < density.size(); box++) {
            var key = new Key(List.copyOf(density.subList(box, density.size())), around);
            LightCells known = known(key);
            light.add(known == null ? found(key) : known);
        }
        return light;
    }

    private synchronized LightCells known(Key key) {
        return lit.get(key);
    }

    /** Finds the light without a lock, so that a frame that needs another box's does not wait for it. */
    private LightCells found(Key key) {
        LightCells light = LightCells.of(key.density, isLayer, physics, key.around);
        remember(key, light);
        return light;
    }

    private synchronized void remember(Key key, LightCells light) {
        lit.put(key, light);
        if (lit.size() > kept) {
            lit.remove(lit.keySet().iterator().next());
        }
    }
}
