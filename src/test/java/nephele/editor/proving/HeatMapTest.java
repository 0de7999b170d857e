package nephele.editor.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import nephele.editor.pane.Mark;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.Solid;
import nephele.engine.level.layout.FacePieces;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A heat map follows edits: what it keeps is what a fresh map computes. */
@Execution(ExecutionMode.CONCURRENT)
class HeatMapTest {
    private static PlacementHeatMap coarse(PlacedLevel placed, HeatMap before) {
        return new PlacementHeatMap(placed, 0.8, 0, 40_000, before);
    }

    private static Level hall() {
        return RoomLevel.hall()
                .gun()
                .pair(new Vec3(0, 1.05, -8), new Vec3(0, 0, 1), new Vec3(-8, 1.05, 0), new Vec3(1, 0, 0))
                .box(3, 0, -8, 4, 3, -7, false)
                .box(-5, 0, 3, -4, 1, 4)
                .box(4, 0, 4, 6, 5, 6)
                .level();
    }

    private static HeatMap computed(PlacementHeatMap map) {
        assertTrue(map.compute(() -> false, () -> {}));
        return map.map();
    }

    /** Moves the last boxes a little, each step another one. */
    private static Level edited(Level level, Random random) {
        List<Solid> solids = new ArrayList<>(level.solids());
        int index = solids.size() - 1 - random.nextInt(3);
        Solid.Box box = (Solid.Box) solids.get(index);
        Vec3 by = new Vec3(random.nextInt(5) - 2, 0, random.nextInt(5) - 2).scaled(0.5);
        solids.set(
                index,
                new Solid.Box(
                        box.id(),
                        box.material(),
                        box.portalable(),
                        box.textureMapping(),
                        box.centre().plus(by),
                        box.size(),
                        box.faces()));
        return level.with(level.materials(), solids);
    }

    @Test
    void afterEachEditTheMapIsTheOneOfTheWholeLevel() {
        PlacedLevel placed = PlacedLevel.of(hall(), NoFiles.AT_ALL);
        HeatMap memory = computed(coarse(placed, null));
        Random random = new Random(3);
        int kept = 0;
        for (int i = 0; i < 6; i++) {
            placed = placed.edited(edited(placed.level(), random));
            PlacementHeatMap next = coarse(placed, memory);
            memory = computed(next);
            kept += next.keptSurfaces();
            assertEquals(computed(coarse(placed, null)).all(), memory.all(), "edit " + i);
        }
        assertTrue(kept > 0, "nothing was kept");
    }

    @Test
    void aPointOfASurfaceHasTheNearestCell() {
        HeatMap memory = computed(coarse(PlacedLevel.of(hall(), NoFiles.AT_ALL), null));
        assertEquals(HeatText.NOT_PORTALABLE, memory.at(new Vec3(3.5, 1.5, -7)).text());
        assertEquals(HeatText.FITS, memory.at(new Vec3(8, 3.1, 0.2)).text());
        assertEquals(null, memory.at(new Vec3(0, 2, 0)));
    }

    @Test
    void regionsCoverWhatTheirCellsCover() {
        HeatMap memory = computed(coarse(PlacedLevel.of(hall(), NoFiles.AT_ALL), null));
        List<Mark> marks = HeatRegions.of(memory);
        double cells = memory.all().stream()
                .mapToDouble(cell -> FacePieces.areaSquareMetres(cell.mark().corners()))
                .sum();
        List<Mark.Polygon> areas = new ArrayList<>();
        marks.forEach(mark -> {
            if (mark instanceof Mark.Polygon area) {
                areas.add(area);
            }
        });
        double covered = areas.stream()
                .mapToDouble(area -> FacePieces.areaSquareMetres(area.corners()))
                .sum();
        assertEquals(cells, covered, 1e-3);
        assertTrue(
                areas.size() < memory.all().size() / 5,
                areas.size() + " of " + memory.all().size());
    }
}
