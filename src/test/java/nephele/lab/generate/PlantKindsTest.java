package nephele.lab.generate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.model.Mesh;
import nephele.engine.model.file.MeshText;
import nephele.engine.model.file.ModelFiles;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each kind is a sound mesh of its stated size for any seed. */
@Execution(ExecutionMode.CONCURRENT)
class PlantKindsTest {
    private static final int MOST_TRIANGLES = 4000;
    private static final long[] SEEDS = {1, 2, -77};

    static List<PlantKind> kinds() {
        return PlantKind.all();
    }

    private static Mesh read(PlantKind kind, long seed) {
        return ModelFiles.read("grown.3d", MeshText.of(kind.grown(seed)), name -> null);
    }

    private static Vector3d vertex(float[] numbers, int vertex) {
        return new Vector3d(numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]);
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void meshesAreFiniteWithUnitNormalsAndNoEmptyTriangles(PlantKind kind) {
        for (long seed : SEEDS) {
            Mesh mesh = read(kind, seed);
            assertTrue(
                    mesh.triangleCount() >= 100 && mesh.triangleCount() <= MOST_TRIANGLES,
                    kind.word() + mesh.triangleCount());
            for (int i = 0; i < mesh.vertexCount(); i++) {
                assertTrue(vertex(mesh.positions(), i).isFinite());
                assertEquals(1, vertex(mesh.normals(), i).length(), 1e-5, kind.word());
            }
            for (float coordinate : mesh.textureCoordinates()) {
                assertTrue(coordinate > 0 && coordinate < 1, kind.word() + coordinate);
            }
            int[] corners = mesh.indices();
            for (int i = 0; i < corners.length; i += 3) {
                Vector3d a = vertex(mesh.positions(), corners[i]);
                Vector3d side = vertex(mesh.positions(), corners[i + 1]).sub(a);
                double area = side.cross(
                                vertex(mesh.positions(), corners[i + 2]).sub(a))
                        .length();
                assertTrue(area > 1e-6, kind.word() + " triangle " + i / 3);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void aKindStandsOnTheGroundAndIsAsHighAsItSays(PlantKind kind) {
        for (long seed : SEEDS) {
            float[] positions = kind.grown(seed).positions();
            double top = IntStream.range(0, positions.length / 3)
                    .mapToDouble(i -> positions[3 * i + 1])
                    .max()
                    .orElseThrow();
            double foot = IntStream.range(0, positions.length / 3)
                    .mapToDouble(i -> positions[3 * i + 1])
                    .min()
                    .orElseThrow();
            double reach = IntStream.range(0, positions.length / 3)
                    .mapToDouble(i -> StrictMath.hypot(positions[3 * i], positions[3 * i + 2]))
                    .max()
                    .orElseThrow();
            assertEquals(kind.heightMetres(), top, 0.006, kind.word());
            assertTrue(foot < 0 && foot > -0.5 * Math.min(1.6, top), kind.word() + " reaches down to " + foot);
            assertTrue(reach > 0.1 * top && reach < 1.5 * top, kind.word() + " reaches " + reach + " m to the side");
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void theSameSeedGivesTheSameBytesAndAnotherSeedOthers(PlantKind kind) {
        byte[] first = MeshText.of(kind.grown(5));
        assertArrayEquals(first, MeshText.of(kind.grown(5)));
        assertFalse(Arrays.equals(first, MeshText.of(kind.grown(6))), kind.word());
    }

    /** Every lobe's middle is near a node of the branches, every tip is in a lobe, so no leaves float and no twig is bare. */
    @Test
    void lobesHangOnBranchesAndCoverTheirTips() {
        PlantDice dice = new PlantDice(3);
        Skeleton skeleton = new Skeleton(new Vector3d());
        List<Vector3d> space = IntStream.range(0, 80)
                .mapToObj(i -> dice.inBall().mul(3).add(0, 4, 0))
                .toList();
        new SpaceColonisation(0.4, 6, 0.8, 0.1).grow(skeleton, space);
        List<Clump> lobes = LeafyPlants.lobesAtTips(skeleton, at -> new Clump(at, 1, 0.8));
        assertTrue(lobes.size() > 5 && skeleton.tips().size() >= lobes.size());
        for (int tip : skeleton.tips()) {
            assertTrue(lobes.stream().anyMatch(lobe -> lobe.depth(skeleton.point(tip)) <= 0.75));
        }
        for (Clump lobe : lobes) {
            assertTrue(
                    skeleton.tips().stream().anyMatch(tip -> skeleton.point(tip).equals(lobe.centre())));
        }
    }

    @Test
    void growthReachesTheSpaceItIsGiven() {
        PlantDice dice = new PlantDice(4);
        Skeleton skeleton = new Skeleton(new Vector3d());
        List<Vector3d> space = IntStream.range(0, 60)
                .mapToObj(i -> dice.inBall().mul(3).add(0, 4, 0))
                .toList();
        new SpaceColonisation(0.4, 6, 0.8, 0).grow(skeleton, space);
        long reached = space.stream()
                .filter(point -> IntStream.range(0, skeleton.size())
                        .anyMatch(node -> skeleton.point(node).distance(point) < 0.8))
                .count();
        assertTrue(reached >= 54, reached + " of 60");
        double[] radii = skeleton.radii(0.3, 2.2);
        assertEquals(0.3, radii[0], 1e-12);
        assertTrue(skeleton.tips().stream().allMatch(tip -> radii[tip] < 0.25));
    }
}
