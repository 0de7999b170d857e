package nephele.editor.brush;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class SimplestSolidTest {
    private static Solid shuffled(Solid solid, long seed) {
        Solid.Planes planes = PlaneForm.of(solid);
        List<PlaneFace> faces = new ArrayList<>(planes.planes());
        Collections.shuffle(faces, new Random(seed));
        return SimplestSolid.of(PlaneForm.with(planes, planes.id(), faces));
    }

    @Test
    void thePlanesOfASimpleSolidAreThatSolidInAnyOrder() {
        RandomSolids solids = new RandomSolids(70);
        for (int i = 0; i < 80; i++) {
            for (Solid solid : List.of(solids.box(), solids.wedge())) {
                assertEquals(solid, shuffled(solid, i));
            }
            Solid.Prism prism = solids.prism();
            assertEquals(
                    prism.sides() == 4 ? Solid.Box.class : Solid.Prism.class,
                    shuffled(prism, i).getClass());
            assertEquals(prism, prism.sides() == 4 ? prism : shuffled(prism, i));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.3, 1e-3, 777.77, 1e4})
    void decimalNumbersComeBackAsWritten(double size) {
        Vec3 sizes = new Vec3(size, 0.7, 0.1);
        Vec3 centre = new Vec3(0.3, -size, 12.34);
        RandomSolids solids = new RandomSolids(71);
        Solid.Box box = SolidTransform.placed(solids.box(), centre, sizes);
        Solid.Wedge wedge = SolidTransform.placed(solids.wedge(), centre, sizes);
        assertEquals(box, shuffled(box, 1));
        assertEquals(wedge, shuffled(wedge, 1));
    }

    @Test
    void anObliqueSolidStaysAsItIs() {
        Solid.Planes solid = new RandomSolids(72).planes();
        assertSame(solid, SimplestSolid.of(solid));
    }

    @Test
    void onlyARegularPrismIsOne() {
        Solid.Prism prism = new RandomSolids(73).prism();
        Solid.Planes planes = PlaneForm.of(prism);
        List<PlaneFace> faces = new ArrayList<>(planes.planes());
        PlaneFace side = faces.get(3);
        faces.set(3, new PlaneFace(side.normal(), side.distanceMetres() - 0.01, null, null, null));
        assertInstanceOf(Solid.Planes.class, SimplestSolid.of(PlaneForm.with(planes, "p", faces)));
        faces.set(3, new PlaneFace(side.normal(), side.distanceMetres(), "metal", null, null));
        Solid.Prism metal = assertInstanceOf(Solid.Prism.class, SimplestSolid.of(PlaneForm.with(planes, "p", faces)));
        assertEquals("metal", FaceLooks.of(metal).get(3).material());
    }
}
