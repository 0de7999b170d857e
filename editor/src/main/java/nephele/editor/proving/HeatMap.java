package nephele.editor.proving;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * A computed heat map. After an edit, only the surfaces near a changed surface or portal are shot at again. Immutable.
 */
public final class HeatMap {
    /** Above this number of changed places, one box around all of them is compared. */
    private static final int MOST_PLACES = 64;

    private final PlacedLevel placed;
    private final double spacingMetres;
    private final Map<HeatSurface, List<HeatCell>> cells;

    /** @param cells by surface, in the order of the level; not changed any more */
    HeatMap(PlacedLevel placed, double spacingMetres, Map<HeatSurface, List<HeatCell>> cells) {
        this.placed = placed;
        this.spacingMetres = spacingMetres;
        this.cells = cells;
    }

    /** Returns the level of the map. */
    public PlacedLevel placed() {
        return placed;
    }

    /** Returns the side of the cells. */
    public double spacingMetres() {
        return spacingMetres;
    }

    Map<HeatSurface, List<HeatCell>> cells() {
        return cells;
    }

    /** Returns all cells. */
    public List<HeatCell> all() {
        return cells.values().stream().flatMap(List::stream).toList();
    }

    /** Returns the cell of the surface on which a point lies; {@code null} for none. */
    public HeatCell at(Vec3 point) {
        for (Map.Entry<HeatSurface, List<HeatCell>> entry : cells.entrySet()) {
            if (entry.getKey().holds(point)) {
                return nearest(entry.getValue(), point);
            }
        }
        return null;
    }

    private static HeatCell nearest(List<HeatCell> cells, Vec3 point) {
        HeatCell nearest = null;
        double least = Double.POSITIVE_INFINITY;
        for (HeatCell cell : cells) {
            double distance = cell.aim().minus(point).length();
            if (distance < least) {
                least = distance;
                nearest = cell;
            }
        }
        return nearest;
    }

    /**
     * Returns the cells that an edit leaves as they are.
     *
     * @param reachMetres distance from a change within which a shot's result can differ
     */
    Map<HeatSurface, List<HeatCell>> kept(PlacedLevel next, List<HeatSurface> surfaces, double reachMetres) {
        Level before = placed.level();
        Level after = next.level();
        boolean isOther = !Objects.equals(before.portalGun(), after.portalGun()) || placed.assets() != next.assets();
        if (isOther) {
            return Map.of();
        }
        List<Aabb> changed = changed(surfaces, before.portals(), after.portals(), reachMetres);
        Map<HeatSurface, List<HeatCell>> kept = new LinkedHashMap<>();
        for (HeatSurface surface : surfaces) {
            List<HeatCell> known = cells.get(surface);
            Aabb box = Aabb.of(surface.corners());
            if (known != null && changed.stream().noneMatch(box::overlaps)) {
                kept.put(surface, known);
            }
        }
        return kept;
    }

    private List<Aabb> changed(
            List<HeatSurface> surfaces, List<PortalSpec> before, List<PortalSpec> after, double reach) {
        List<Aabb> places = new ArrayList<>();
        Set<HeatSurface> now = new HashSet<>(surfaces);
        cells.keySet().stream()
                .filter(surface -> !now.contains(surface))
                .forEach(gone -> places.add(Aabb.of(gone.corners()).grown(reach)));
        now.stream()
                .filter(surface -> !cells.containsKey(surface))
                .forEach(added -> places.add(Aabb.of(added.corners()).grown(reach)));
        before.stream().filter(portal -> !after.contains(portal)).forEach(portal -> places.add(around(portal, reach)));
        after.stream().filter(portal -> !before.contains(portal)).forEach(portal -> places.add(around(portal, reach)));
        if (places.size() <= MOST_PLACES) {
            return places;
        }
        return List.of(places.stream().reduce(Aabb.EMPTY, Aabb::union));
    }

    private static Aabb around(PortalSpec portal, double reach) {
        double size = Math.max(portal.widthMetres(), portal.heightMetres());
        return Aabb.of(List.of(portal.centre())).grown(size + reach);
    }
}
