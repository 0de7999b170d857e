package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.DetailRanges;
import nephele.engine.math.heightfield.DetailTiles;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldDetail;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.render.resource.TerrainTiles;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.workshop.art.bench.BenchTerrain;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Matrix4d;

/** Compares the triangles that views draw of a terrain with all of its triangles, at every sample in the picture. */
public final class TerrainDetailProof implements Proof {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final double FAR_METRES = 2000;
    private static final double LEAST_RATIO = 10;
    /** The side from which on the ratio of triangles is claimed; a small ground is near everywhere. */
    private static final int LARGE_SIDE = 4097;

    private static final String DRAWN = "triangles drawn";
    private static final String IN_VIEW = "triangles of the parts in view";

    private final int side;

    /** @param side samples along a side of the terrain */
    public TerrainDetailProof(int side) {
        this.side = side;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "terrain-detail",
                "On a terrain of " + side + " x " + side
                        + " samples 1 m apart, seven octaves of noise and 127 m high, no"
                        + " sample in a picture of 1280 x 720 is drawn more than 1 pixel from its place, and all"
                        + " cameras together draw at most a tenth of the triangles of the parts in view.",
                "cameras",
                1000,
                20);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        HeightField field =
                HeightField.of(new Vec3(-(side - 1) / 2.0, 0, -(side - 1) / 2.0), 1, side, side, BenchTerrain::metres);
        HeightFieldDetail detail = HeightFieldDetail.of(field);
        Tally tally = new Tally(field);
        for (long unit = from; unit < from + count; unit++) {
            tally.take(unit, view(field, new SplittableRandom(unit)), detail);
            progress.unitsDone(unit + 1 - from);
        }
        return tally.result(count);
    }

    @Override
    public ProofResult judged(ProofResult soFar) {
        double ratio = soFar.value(IN_VIEW) / soFar.value(DRAWN);
        if (side < LARGE_SIDE || ratio >= LEAST_RATIO) {
            return soFar;
        }
        List<String> failures = List.of("only " + ratio + " times fewer triangles");
        return soFar.and(ProofResult.of(0, failures));
    }

    /** Returns a view from 1.5 m to 150 m above the ground, of 40° to 80°, mostly not far from level. */
    private static View view(HeightField field, SplittableRandom random) {
        double reach = field.cellColumns() * 0.45;
        double x = reach * (2 * random.nextDouble() - 1);
        double z = reach * (2 * random.nextDouble() - 1);
        double above = 1.5 * Math.pow(100, random.nextDouble());
        Vec3 eye = new Vec3(x, HeightFieldSurface.y(field, x, z) + above, z);
        double yaw = 2 * Math.PI * random.nextDouble();
        double pitch =
                Math.toRadians(random.nextInt(8) == 0 ? -85 * random.nextDouble() : 25 - 50 * random.nextDouble());
        Vec3 target =
                eye.plus(new Vec3(Math.cos(pitch) * Math.cos(yaw), Math.sin(pitch), Math.cos(pitch) * Math.sin(yaw)));
        double fov = Math.toRadians(40 + 40 * random.nextDouble());
        Projection projection = new Projection(fov, (double) WIDTH / HEIGHT, 0.05, FAR_METRES);
        return View.lookAt(eye, target, new Vec3(0, 1, 0), projection);
    }

    /** The results so far. */
    private static final class Tally {
        private final HeightField field;
        private final DetailTiles tiles = new DetailTiles();
        private final List<String> failures = new ArrayList<>();
        private double worstPixels;
        private double worstOfView;
        private double mostTriangles;
        private long drawn;
        private long inView;
        private long samples;

        Tally(HeightField field) {
            this.field = field;
        }

        void take(long unit, View view, HeightFieldDetail detail) {
            Matrix4d clip = view.clipFromRelative(new Matrix4d());
            Frustum visible = Frustum.of(clip, view.eye());
            DetailRanges ranges = DetailRanges.of(detail, TerrainTiles.scale(view.projection(), WIDTH, HEIGHT, 1));
            tiles.select(ranges, TerrainTiles.detailView(view), visible);
            worstOfView = 0;
            double tanHalfWidth = view.projection().tanHalfWidth();
            double tanHalfHeight = view.projection().tanHalfHeight();
            new DrawnDetail(field, TerrainTiles.detailView(view), tiles)
                    .samples((column, row, drawnHeight) ->
                            compare(view, tanHalfWidth, tanHalfHeight, column, row, drawnHeight));
            worstPixels = Math.max(worstPixels, worstOfView);
            if (worstOfView > 1) {
                failures.add("camera " + unit + ": a sample is drawn " + worstOfView + " pixels from its place");
            }
            long triangles = 2L * tiles.count() * HeightFieldDetail.TILE_CELLS * HeightFieldDetail.TILE_CELLS;
            mostTriangles = Math.max(mostTriangles, triangles);
            drawn += triangles;
            inView += trianglesInView(visible);
        }

        /** Measures the distance of a sample from the place where the view draws it, if both are within the picture. */
        private void compare(
                View view, double tanHalfWidth, double tanHalfHeight, int column, int row, double drawnHeight) {
            double x = field.x(column) - view.eyeX();
            double z = field.z(row) - view.eyeZ();
            double y = field.y(field.height(column, row)) - view.eyeY();
            double up = drawnHeight - field.height(column, row);
            double depth = -view.alongBack(x, y, z);
            double drawnDepth = -view.alongBack(x, y + up, z);
            if (Math.min(depth, drawnDepth) < view.projection().nearMetres()) {
                return;
            }
            double right = view.alongRight(x, y, z) / depth / tanHalfWidth;
            double above = view.alongUp(x, y, z) / depth / tanHalfHeight;
            double drawnRight = view.alongRight(x, y + up, z) / drawnDepth / tanHalfWidth;
            double drawnAbove = view.alongUp(x, y + up, z) / drawnDepth / tanHalfHeight;
            if (isWithin(right, above) && isWithin(drawnRight, drawnAbove)) {
                samples++;
                double across = (drawnRight - right) * WIDTH / 2;
                double along = (drawnAbove - above) * HEIGHT / 2;
                worstOfView = Math.max(worstOfView, Math.sqrt(across * across + along * along));
            }
        }

        private static boolean isWithin(double right, double above) {
            return Math.abs(right) <= 1 && Math.abs(above) <= 1;
        }

        /** Returns the triangles that are drawn without coarser ones: of all blocks of 64 × 64 cells in view. */
        private long trianglesInView(Frustum visible) {
            int level = field.blockLevel(TerrainMesh.CHUNK_CELLS);
            double[] bounds = new double[6];
            long blocks = 0;
            for (int row = 0; row < field.blockRows(level); row++) {
                for (int column = 0; column < field.blockColumns(level); column++) {
                    field.writeBlock(level, column, row, bounds);
                    blocks += visible.classify(bounds, 0, visible.allPlanes()) != Frustum.OUTSIDE ? 1 : 0;
                }
            }
            return blocks * 2 * TerrainMesh.CHUNK_CELLS * TerrainMesh.CHUNK_CELLS;
        }

        ProofResult result(long units) {
            return ProofResult.of(
                    units,
                    failures,
                    Figure.greatest("greatest error", worstPixels, "pixels"),
                    Figure.greatest("most triangles drawn", mostTriangles, ""),
                    Figure.sum(DRAWN, drawn, ""),
                    Figure.sum(IN_VIEW, inView, ""),
                    Figure.sum("samples compared", samples, ""));
        }
    }
}
