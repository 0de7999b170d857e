package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.LongStream;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.level.Body;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class DroppedPileTest {
    private static final List<DroppedPile> PILES =
            LongStream.range(0, 600).mapToObj(DroppedPile::of).toList();

    @Test
    void everyPileStartsFreeOfOverlap() {
        for (DroppedPile pile : PILES) {
            var depth = new BodyDepth(pile.table(), pile.world());
            Bodies start = Bodies.of(pile.starts());
            for (int i = 0; i < start.size(); i++) {
                assertEquals(0, depth.inSolids(start, i), pile::inWords);
                assertEquals(0, depth.inBodies(start, i), pile::inWords);
                assertTrue(pile.outsideMetres(start.centre(i, new Vector3d())) < 0, pile::inWords);
            }
        }
    }

    @Test
    void theNumberIsTheSeed() {
        assertEquals(PILES.get(7).inWords(), DroppedPile.of(7).inWords());
        assertEquals(PILES.get(7).starts(), DroppedPile.of(7).starts());
    }

    @Test
    void aThirdIsAtPortalsOfEveryKind() {
        var kinds = new TreeMap<String, Integer>();
        PILES.forEach(pile -> kinds.merge(pile.portals().kind(), 1, Integer::sum));
        assertEquals(400, kinds.remove("no portals"));
        assertEquals(Set.of("floor and floor", "floor and wall", "wall and wall", "floor and ceiling"), kinds.keySet());
        kinds.forEach((kind, count) -> assertTrue(count > 30, kind + " " + count));
        PILES.stream()
                .filter(DroppedPile::hasPortals)
                .forEach(pile -> assertTrue(pile.world().portals().isOpen(0)));
    }

    @Test
    void ratesCountsAndKindsAreAllThere() {
        var shapes = new HashSet<Class<?>>();
        var counts = new HashSet<Integer>();
        for (DroppedPile pile : PILES) {
            counts.add(pile.table().size());
            assertTrue(pile.ticksPerSecond() >= 20 && pile.ticksPerSecond() <= 1000, pile::inWords);
            for (int i = 0; i < pile.table().size(); i++) {
                shapes.add(pile.table().body(i).getClass());
            }
        }
        assertEquals(Set.of(Body.Box.class, Body.Sphere.class, Body.Capsule.class), shapes);
        assertEquals(Set.of(1, 2, 3, 4), counts);
        long slow = PILES.stream().filter(pile -> pile.ticksPerSecond() < 141).count();
        assertEquals(300, slow, 40, "half are below the geometric mean");
    }

    @Test
    void mostBodiesStartAtRestAndHalfOfThemUpright() {
        long bodies = PILES.stream().mapToLong(pile -> pile.starts().size()).sum();
        long spinning = PILES.stream()
                .flatMap(pile -> pile.starts().stream())
                .filter(start -> start.spin().x() != 0)
                .count();
        long upright = PILES.stream()
                .flatMap(pile -> pile.starts().stream())
                .filter(start -> start.orientation().w == 1)
                .count();
        assertEquals(.25, (double) spinning / bodies, .04);
        assertEquals(.5, (double) upright / bodies, .04);
    }
}
