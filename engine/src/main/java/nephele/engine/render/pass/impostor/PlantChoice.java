package nephele.engine.render.pass.impostor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Frustum;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.PlantList;
import nephele.engine.render.resource.PlantedScene;
import nephele.engine.render.resource.PlantedScene.Cluster;
import nephele.engine.scene.View;

/**
 * The plants that a view draws, the nearest clusters first. Far clusters are chosen as a whole, and the farthest lose some
 * of their plants; clusters in which some plants are large enough for meshes are looked through.
 */
final class PlantChoice implements GlObject {
    private final PlantedScene scene;
    private final PlantSizes sizes;
    private final BillboardList impostors;
    private final List<PlantList> meshes = new ArrayList<>();
    private final long[] order;
    private int seen;
    private float eyeX;
    private float eyeY;
    private float eyeZ;

    PlantChoice(GlContext gl, PlantedScene scene, PlantSizes sizes) {
        this.scene = scene;
        this.sizes = sizes;
        impostors = new BillboardList(gl, 1);
        scene.meshes().forEach(mesh -> meshes.add(new PlantList(gl)));
        order = new long[scene.clusters().size()];
    }

    /** @param pixelsPerRadian of the view's middle */
    void find(View view, Frustum limits, double pixelsPerRadian) {
        impostors.begin();
        meshes.forEach(PlantList::begin);
        eyeX = (float) (view.eyeX() - scene.anchor().x());
        eyeY = (float) (view.eyeY() - scene.anchor().y());
        eyeZ = (float) (view.eyeZ() - scene.anchor().z());
        sort(view, limits);
        for (int i = 0; i < seen; i++) {
            add(scene.clusters().get((int) order[i]), view, pixelsPerRadian);
        }
    }

    private void sort(View view, Frustum limits) {
        seen = 0;
        List<Cluster> clusters = scene.clusters();
        for (int i = 0; i < clusters.size(); i++) {
            if (limits.mayIntersect(clusters.get(i).bounds())) {
                float distance = (float) clusters.get(i).bounds().nearest(view.eyeX(), view.eyeY(), view.eyeZ());
                order[seen++] = (long) Float.floatToIntBits(distance) << 32 | i;
            }
        }
        Arrays.sort(order, 0, seen);
    }

    private void add(Cluster cluster, View view, double pixelsPerRadian) {
        double near = cluster.bounds().nearest(view.eyeX(), view.eyeY(), view.eyeZ());
        double far = cluster.bounds().farthest(view.eyeX(), view.eyeY(), view.eyeZ());
        if (sizes.isImpostor(cluster.most() * pixelsPerRadian / near)) {
            int drawn = PlantSizes.drawn(cluster.end() - cluster.first(), cluster.most() * pixelsPerRadian / near);
            for (int plant = cluster.first(); plant < cluster.first() + drawn; plant++) {
                impostors.add(plant);
            }
        } else if (sizes.isMesh(cluster.least() * pixelsPerRadian / far)) {
            for (int plant = cluster.first(); plant < cluster.end(); plant++) {
                meshes.get(scene.kind(plant)).add(plant);
            }
        } else {
            for (int plant = cluster.first(); plant < cluster.end(); plant++) {
                double pixels = scene.size(plant) * pixelsPerRadian / distance(plant);
                if (!sizes.isMesh(pixels)) {
                    impostors.add(plant);
                }
                if (!sizes.isImpostor(pixels)) {
                    meshes.get(scene.kind(plant)).add(plant);
                }
            }
        }
    }

    private double distance(int plant) {
        float x = scene.middle(plant, 0) - eyeX;
        float y = scene.middle(plant, 1) - eyeY;
        float z = scene.middle(plant, 2) - eyeZ;
        return Math.sqrt(x * x + y * y + z * z);
    }

    BillboardList impostors() {
        return impostors;
    }

    /** Returns the plants of a kind that are drawn as meshes. */
    PlantList meshes(int kind) {
        return meshes.get(kind);
    }

    @Override
    public void close() {
        impostors.close();
        meshes.forEach(PlantList::close);
    }
}
