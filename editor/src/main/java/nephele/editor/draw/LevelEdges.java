package nephele.editor.draw;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.editor.pane.PaneKind;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.line.LineLayer;
import nephele.engine.render.line.LineProjection;
import nephele.engine.render.line.WorldEdges;

/**
 * The edges of a level's solids and models as lines on the GPU, for panes of one kind; an edit computes those of changed
 * shapes only. In a plan, edges of a solid that are behind each other are one line: a box has four instead of twelve.
 */
final class LevelEdges implements AutoCloseable {
    private final GlContext gl;
    private final PaneKind kind;
    /** Six numbers for each edge, by {@link Brush} or {@link PlacedModel}. */
    private Map<Object, float[]> known = new IdentityHashMap<>();

    private StaticShapes drawn;
    private Vec3 origin;
    private WorldEdges edges;

    LevelEdges(GlContext gl, PaneKind kind) {
        this.gl = gl;
        this.kind = kind;
    }

    /** Follows an edit. */
    void show(StaticShapes shapes) {
        if (shapes == drawn) {
            return;
        }
        drawn = shapes;
        if (origin == null) {
            origin = shapes.bounds().isEmpty() ? Vec3.ZERO : shapes.bounds().centre();
        }
        Map<Object, float[]> now = new IdentityHashMap<>();
        List<float[]> all = new ArrayList<>();
        for (Brush brush : shapes.solids()) {
            float[] ends = known.get(brush);
            all.add(ends == null ? ofBrush(brush) : ends);
            now.put(brush, all.get(all.size() - 1));
        }
        for (PlacedModel model : shapes.models().all()) {
            float[] ends = known.get(model);
            all.add(ends == null ? ofModel(model.triangles()) : ends);
            now.put(model, all.get(all.size() - 1));
        }
        known = now;
        close();
        edges = new WorldEdges(gl, origin, joined(all));
    }

    private static float[] joined(List<float[]> all) {
        float[] joined = new float[all.stream().mapToInt(ends -> ends.length).sum()];
        int at = 0;
        for (float[] ends : all) {
            System.arraycopy(ends, 0, joined, at, ends.length);
            at += ends.length;
        }
        return joined;
    }

    private float[] ofBrush(Brush brush) {
        List<Vec3> vertices = new ArrayList<>();
        Map<Vec3, Integer> indices = new HashMap<>();
        Set<Long> pairs = new HashSet<>();
        for (Brush.BrushFace face : brush.faces()) {
            List<Vec3> polygon = face.polygon();
            for (int i = 0; i < polygon.size(); i++) {
                int from = index(projected(polygon.get(i)), vertices, indices);
                int to = index(projected(polygon.get((i + 1) % polygon.size())), vertices, indices);
                if (from != to) {
                    pairs.add(pair(from, to));
                }
            }
        }
        float[] ends = new float[6 * pairs.size()];
        int at = 0;
        for (long pair : pairs) {
            at = put(vertices.get((int) (pair >> 32)), ends, at);
            at = put(vertices.get((int) pair), ends, at);
        }
        return ends;
    }

    /** Returns the vertex without its distance in a plan. */
    private Vec3 projected(Vec3 vertex) {
        return switch (kind) {
            case PERSPECTIVE -> vertex;
            case TOP -> new Vec3(vertex.x(), origin.y(), vertex.z());
            case FRONT -> new Vec3(vertex.x(), vertex.y(), origin.z());
            case SIDE -> new Vec3(origin.x(), vertex.y(), vertex.z());
        };
    }

    private static int index(Vec3 vertex, List<Vec3> vertices, Map<Vec3, Integer> indices) {
        return indices.computeIfAbsent(vertex, added -> {
            vertices.add(added);
            return vertices.size() - 1;
        });
    }

    private float[] ofModel(WorldTriangles triangles) {
        Set<Long> pairs = new HashSet<>();
        int[] corners = triangles.vertices();
        for (int at = 0; at < corners.length; at += 3) {
            pairs.add(pair(corners[at], corners[at + 1]));
            pairs.add(pair(corners[at + 1], corners[at + 2]));
            pairs.add(pair(corners[at + 2], corners[at]));
        }
        float[] ends = new float[6 * pairs.size()];
        int at = 0;
        for (long pair : pairs) {
            at = put(vertex(triangles, (int) (pair >> 32)), ends, at);
            at = put(vertex(triangles, (int) pair), ends, at);
        }
        return ends;
    }

    private static Vec3 vertex(WorldTriangles triangles, int index) {
        double[] all = triangles.positions();
        return new Vec3(all[3 * index], all[3 * index + 1], all[3 * index + 2]);
    }

    private static long pair(int some, int other) {
        return (long) Math.min(some, other) << 32 | Math.max(some, other);
    }

    private int put(Vec3 vertex, float[] ends, int at) {
        ends[at] = (float) (vertex.x() - origin.x());
        ends[at + 1] = (float) (vertex.y() - origin.y());
        ends[at + 2] = (float) (vertex.z() - origin.z());
        return at + 3;
    }

    void draw(LineProjection projection, DisplayColour colour, LineLayer layer, RenderTarget picture) {
        edges.draw(projection, colour, layer, picture);
    }

    @Override
    public void close() {
        if (edges != null) {
            edges.close();
            edges = null;
        }
    }
}
