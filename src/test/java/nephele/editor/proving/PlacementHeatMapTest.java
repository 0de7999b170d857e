package nephele.editor.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import nephele.editor.pane.MarkColour;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.layout.FacePieces;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.ShotRay;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The heat map says what a shot straight at each of its cells does. */
@Execution(ExecutionMode.CONCURRENT)
class PlacementHeatMapTest {
    private static PlacementHeatMap coarse(PlacedLevel placed, HeatMap before) {
        return new PlacementHeatMap(placed, 0.5, 0.3, 40_000, before);
    }

    /** A hall with a fixed pair, a pillar that takes no portals, and a small portalable block. */
    private static Level hall() {
        return RoomLevel.hall()
                .gun()
                .pair(new Vec3(0, 1.05, -8), new Vec3(0, 0, 1), new Vec3(-8, 1.05, 0), new Vec3(1, 0, 0))
                .box(3, 0, -8, 4, 3, -7, false)
                .box(-5, 0, 3, -4, 1, 4)
                .level();
    }

    private static PlacedLevel placed(Level level) {
        return PlacedLevel.of(level, NoFiles.AT_ALL);
    }

    private static List<HeatCell> cells(PlacementHeatMap map) {
        assertTrue(map.compute(() -> false, () -> {}));
        return map.map().all();
    }

    @Test
    void cellsAgreeWithShotsFromFarther() {
        PlacedLevel placed = placed(hall());
        List<HeatCell> cells = cells(coarse(placed, null));
        Placement placement = new Placement(
                PlacementSurfaces.of(placed.statics()), Gun.of(placed.level().portalGun()));
        List<Portal> fixed = placed.level().portals().stream().map(Portal::of).toList();
        Random random = new Random(1);
        for (int i = 0; i < 400; i++) {
            HeatCell cell = cells.get(random.nextInt(cells.size()));
            Vec3 a = cell.mark().corners().get(0);
            Vec3 normal = Vec3.of(cell.mark()
                    .corners()
                    .get(1)
                    .minus(a)
                    .cross(cell.mark().corners().get(2).minus(a))
                    .toVector()
                    .normalize());
            boolean isLevel = Math.abs(normal.y()) > 0.99;
            Basis view = isLevel
                    ? Basis.ofYawPitch(0.3, -normal.y() * Math.PI / 2)
                    : Basis.lookAt(normal, Vec3.ZERO, new Vec3(0, 1, 0), Basis.WORLD);
            Vec3 eye = cell.aim().addScaled(0.05, normal);
            PlacementResult shot = placement.place("p", new ShotRay(eye, view), fixed, Obstacles.NONE);
            if (shot instanceof PlacementResult.Fits fits) {
                assertEquals(fits.slideMetres(), cell.metres(), 1e-5, cell.toString());
                assertTrue(cell.colour() != MarkColour.REFUSED, cell.toString());
            } else {
                assertEquals(
                        ((PlacementResult.Refused) shot).reason().name(),
                        cell.text().name(),
                        cell.toString());
            }
        }
    }

    @Test
    void everyResultOccursWhereItShould() {
        List<HeatCell> cells = cells(coarse(placed(hall()), null));
        Set<HeatText> texts = EnumSet.noneOf(HeatText.class);
        cells.forEach(cell -> texts.add(cell.text()));
        assertEquals(
                EnumSet.of(
                        HeatText.FITS,
                        HeatText.SLIDES,
                        HeatText.NOT_PORTALABLE,
                        HeatText.OVERLAPS_OTHER,
                        HeatText.TOO_SMALL,
                        HeatText.EDGE),
                texts);
        HeatCell middle = nearest(cells, new Vec3(8, 3, 0));
        assertEquals(HeatText.FITS, middle.text());
        assertEquals(HeatText.SLIDES, nearest(cells, new Vec3(8, 0.75, 0)).text());
        assertEquals(HeatText.EDGE, nearest(cells, new Vec3(8, 0.2, 0)).text());
        assertEquals(HeatText.TOO_SMALL, nearest(cells, new Vec3(-4.4, 1, 3.4)).text());
    }

    private static HeatCell nearest(List<HeatCell> cells, Vec3 place) {
        return cells.stream()
                .min((a, b) -> Double.compare(
                        a.aim().minus(place).length(), b.aim().minus(place).length()))
                .orElseThrow();
    }

    @Test
    void cellsCoverTheirSurfacesOnce() {
        Level level = new RoomLevel().box(0.1, 0, 0.3, 2.2, 3, 1.7).gun().level();
        double area = cells(coarse(placed(level), null)).stream()
                .mapToDouble(cell -> FacePieces.areaSquareMetres(cell.mark().corners()))
                .sum();
        assertEquals(2 * (2.1 * 3 + 2.1 * 1.4 + 3 * 1.4), area, 1e-9);
    }

    @Test
    void aLargeLevelGetsCoarserCells() {
        Level level = new RoomLevel().box(-500, -1, -500, 500, 0, 500).gun().level();
        PlacementHeatMap map = new PlacementHeatMap(placed(level), 0.25, 0, 2000, null);
        assertTrue(map.spacingMetres() > 0.25);
        int cells = cells(map).size();
        assertTrue(cells <= 2000 && cells > 400, "" + cells);
    }

    @Test
    void cancellingStopsIt() {
        PlacementHeatMap map = coarse(placed(hall()), null);
        int all = cells(coarse(placed(hall()), null)).size();
        int[] asked = {0};
        int[] surfaces = {0};
        assertFalse(map.compute(() -> ++asked[0] > all / 2, () -> surfaces[0]++));
        int cells = map.map().all().size();
        assertTrue(cells > 0 && cells <= all / 2, cells + " of " + all);
        assertEquals(map.map().cells().size(), surfaces[0], "whole surfaces only");
    }

    @Test
    void reasonsAreInThreeLanguages() {
        HeatCell cell = nearest(cells(coarse(placed(hall()), null)), new Vec3(8, 0.75, 0));
        assertEquals(
                "A portal slides 0.30 m to fit",
                cell.text().words(cell.metres()).english());
        assertEquals(
                "Um portal desliza 0,30 m para caber",
                cell.text().words(cell.metres()).brazilian());
    }
}
