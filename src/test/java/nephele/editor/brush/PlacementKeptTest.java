package nephele.editor.brush;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

@Execution(ExecutionMode.CONCURRENT)
class PlacementKeptTest {
    private static final Vec3 PIVOT = new Vec3(0.5, -1, 2);
    private static final Solid.Face CUT = new Solid.Face("metal", true, new TexturePlacement(9, 9, 9, 9, 9));

    /**
     * An edit.
     *
     * @param move where it takes the points of faces that survive
     * @param all true if all faces survive
     */
    record Edit(String name, Function<Solid, BrushEdit<List<Solid>>> change, UnaryOperator<Vec3> move, boolean all) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static Edit one(String name, Function<Solid, BrushEdit<Solid>> change, UnaryOperator<Vec3> move) {
        return new Edit(name, solid -> change.apply(solid).map(List::of), move, true);
    }

    private static Edit looks(String name, UnaryOperator<Solid> change) {
        return one(name, solid -> BrushEdit.done(change.apply(solid)), p -> p);
    }

    private static Edit cutting(String name, Function<Solid, BrushEdit<List<Solid>>> change) {
        return new Edit(name, change, p -> p, false);
    }

    private static Edit scaling(double x, double y, double z) {
        Vec3 f = new Vec3(x, y, z);
        return one("scale " + f, solid -> SolidTransform.scaled(solid, PIVOT, f), p -> {
            Vec3 v = p.minus(PIVOT);
            return PIVOT.plus(new Vec3(v.x() * x, v.y() * y, v.z() * z));
        });
    }

    private static Edit turning(Vec3 axis, double degrees) {
        LockedMove move = LockedMove.turn(PIVOT, axis, degrees);
        return one(
                "turn " + axis + " by " + degrees,
                solid -> SolidTransform.rotated(solid, PIVOT, axis, degrees),
                move::point);
    }

    static Stream<Edit> edits() {
        Vec3 by = new Vec3(1.25, -3, 0.5);
        return Stream.of(
                one("move", solid -> BrushEdit.done(SolidTransform.moved(solid, by)), by::plus),
                turning(new Vec3(0, 1, 0), 90),
                turning(new Vec3(0, 1, 0), 180),
                turning(new Vec3(1, 0, 0), 270),
                turning(new Vec3(0, 1, 0), 30),
                turning(new Vec3(1, 2, -3), 77),
                scaling(2, 0.5, 2),
                scaling(2, 3, 0.5),
                scaling(-1, 1, 1),
                scaling(1, -1, 1),
                scaling(1, 1, -1),
                scaling(-1, -1, -1),
                looks("material of a face", solid -> FaceLooks.withMaterial(solid, 0, "tile")),
                looks("material", solid -> FaceLooks.withMaterial(solid, "tile")),
                looks("grey face", solid -> FaceLooks.withMaterial(solid, 1, null)),
                looks("portalable face", solid -> FaceLooks.withPortalable(solid, 2, true)),
                looks("portalable", solid -> FaceLooks.withPortalable(solid, true)),
                looks("other id", solid -> solid.withId("other")),
                looks("simplest record", solid -> SimplestSolid.of(PlaneForm.of(solid))),
                one("clip and merge", solid -> clipped(solid).flatMap(BrushBoolean::merged), p -> p),
                cutting("clip", PlacementKeptTest::clipped),
                cutting("extrude", solid -> FaceExtrude.extruded(solid, 0, 0.25).map(List::of)),
                cutting("extrude as new", solid -> FaceExtrude.extrudedAsNew(solid, 0, 0.25, "new")),
                cutting("split", solid -> FaceExtrude.extrudedAsNew(solid, 0, -0.125, "new")),
                cutting("hollow", solid -> BrushBoolean.hollowed(solid, 0.03125, solid::id)),
                cutting("vertex", PlacementKeptTest::withVertexMoved),
                cutting("subtract", solid -> BrushBoolean.subtracted(solid, cutter(solid), solid::id)),
                cutting("intersect", solid -> BrushBoolean.intersected(solid, cutter(solid))
                        .map(List::of)));
    }

    /** Returns a point inside. */
    private static Vec3 middle(Solid solid) {
        List<Vec3> vertices = VertexEdit.vertices(solid);
        return vertices.stream().reduce(Vec3.ZERO, Vec3::plus).scaled(1.0 / vertices.size());
    }

    private static BrushEdit<List<Solid>> clipped(Solid solid) {
        Plane plane = Plane.through(Plane.of(new Vec3(1, 0.25, 0.5), 0).normal(), middle(solid));
        return BrushClip.clipped(solid, plane, BrushClip.Keep.BOTH, CUT, "front");
    }

    private static Solid cutter(Solid solid) {
        return SolidShape.box("cutter", middle(solid), middle(solid).plus(new Vec3(10, 10, 10)));
    }

    private static BrushEdit<List<Solid>> withVertexMoved(Solid solid) {
        Vec3 vertex = VertexEdit.vertices(solid).get(0);
        return VertexEdit.moved(
                        solid, List.of(vertex), vertex.minus(middle(solid)).scaled(0.125))
                .map(List::of);
    }

    /** Returns the solid with a different placement on each face. */
    private static Solid painted(Solid solid) {
        Solid painted = solid;
        for (String name : SolidFaces.names(solid)) {
            int i = SolidFaces.names(solid).indexOf(name) + 1;
            Solid.Face said = SolidFaces.authored(solid, name);
            TexturePlacement placement = new TexturePlacement(i / 8.0, -i, 10 * i, i, -i);
            painted = SolidFaces.with(painted, name, new Solid.Face(said.material(), said.portalable(), placement));
        }
        return painted;
    }

    private static List<Solid> solids() {
        RandomSolids random = new RandomSolids(80);
        return List.of(random.box(), random.wedge(), random.prism(), random.planes(), random.prism(), random.planes());
    }

    private static boolean isOn(BrushFace face, List<Vec3> points) {
        return points.stream().allMatch(p -> Math.abs(face.plane().signedDistance(p)) < 1e-7);
    }

    @ParameterizedTest
    @MethodSource("edits")
    void survivingFacesKeepTheirPlacement(Edit edit) {
        for (Solid solid : solids()) {
            Solid painted = painted(solid);
            List<BrushFace> after = new ArrayList<>();
            edit.change
                    .apply(painted)
                    .result()
                    .orElseThrow()
                    .forEach(part -> after.addAll(Brush.of(part).faces()));
            int survivors = 0;
            for (BrushFace face : Brush.of(painted).faces()) {
                List<Vec3> points = face.polygon().stream().map(edit.move).toList();
                List<BrushFace> same =
                        after.stream().filter(other -> isOn(other, points)).toList();
                same.forEach(other -> assertEquals(face.texture(), other.texture(), face.name() + " of " + painted));
                survivors += same.isEmpty() ? 0 : 1;
            }
            int least = edit.all ? Brush.of(painted).faces().size() : 1;
            assertTrue(survivors >= least, survivors + " of " + painted);
        }
    }

    @Test
    void aPrismWithPlacementsStaysAPrism() {
        Solid.Prism prism = (Solid.Prism) painted(new RandomSolids(81).prism());
        Solid turned = SolidTransform.rotated(prism, PIVOT, new Vec3(0, 1, 0), 180)
                .result()
                .orElseThrow();
        assertEquals(prism.sides() % 2 == 0, turned instanceof Solid.Prism);
        assertEquals(
                prism,
                SolidTransform.rotated(turned, PIVOT, new Vec3(0, 1, 0), 180)
                        .result()
                        .orElseThrow());
    }

    @Test
    void newFacesShowThePictureOfTheFaceTheyComeFrom() {
        for (Solid solid : solids()) {
            Solid painted = painted(solid);
            BrushFace from = Brush.of(painted).faces().get(0);
            Vec3 out = from.plane().normal();
            Solid longer = FaceExtrude.extruded(painted, 0, 0.25).result().orElseThrow();
            assertEquals(from.texture(), SolidShape.towards(longer, out).texture());
            List<Solid> two =
                    FaceExtrude.extrudedAsNew(painted, 0, 0.25, "new").result().orElseThrow();
            assertEquals(from.texture(), SolidShape.towards(two.get(1), out).texture());
            List<Solid> halves = clipped(painted).result().orElseThrow();
            Vec3 cut = Plane.of(new Vec3(1, 0.25, 0.5), 0).normal();
            assertEquals(CUT.texture(), SolidShape.towards(halves.get(0), cut).texture());
            assertEquals(
                    CUT.texture(),
                    SolidShape.towards(halves.get(1), cut.negated()).texture());
        }
    }

    @Test
    void facesOfACutterBringTheirPlacement() {
        Solid box = SolidShape.box("box", Vec3.ZERO, new Vec3(2, 2, 2));
        Solid cutter = painted(SolidShape.box("cutter", new Vec3(1, -1, -1), new Vec3(3, 3, 3)));
        TexturePlacement placement = SolidFaces.authored(cutter, "-x").texture();
        Solid common = BrushBoolean.intersected(box, cutter).result().orElseThrow();
        assertEquals(placement, SolidFaces.authored(common, "-x").texture());
    }
}
