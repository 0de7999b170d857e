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
    /** As {@code PLANT_FADE} in {@code plant-fade.glsl}. */
    private static final double FADE = 1.2;

    /** More than floats err. */
    private static final double MARGIN = 1e-4;

    /** As {@code PLANT_THIN} and {@code PLANT_SHRINK} in {@code plant-fade.glsl}. */
    private static final double THIN_PIXELS = 8;

    private static final double SHRINK = 0.25;

    private final PlantedScene scene;
    /** Below so many pixels only impostors are drawn; 0 for meshes alone. */
    private final double impostorPixels;

    private final BillboardList impostors;
    private final List<PlantList> meshes = new ArrayList<>();
    private final long[] order;
    private int visible;
    private float eyeX;
    private float eyeY;
    private float eyeZ;

    PlantChoice(GlContext gl, PlantedScene scene, double impostorPixels) {
        this.scene = scene;
        this.impostorPixels = impostorPixels;
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
        for (int i = 0; i < visible; i++) {
            add(scene.clusters().get((int) order[i]), view, pixelsPerRadian);
        }
    }

    private void sort(View view, Frustum limits) {
        visible = 0;
        List<Cluster> clusters = scene.clusters();
        for (int i = 0; i < clusters.size(); i++) {
            if (limits.mayIntersect(clusters.get(i).bounds())) {
                float distance = (float) clusters.get(i).bounds().nearest(view.eyeX(), view.eyeY(), view.eyeZ());
                order[visible++] = (long) Float.floatToIntBits(distance) << 32 | i;
            }
        }
        Arrays.sort(order, 0, visible);
    }

    private void add(Cluster cluster, View view, double pixelsPerRadian) {
        double near = cluster.bounds().nearest(view.eyeX(), view.eyeY(), view.eyeZ());
        double far = cluster.bounds().farthest(view.eyeX(), view.eyeY(), view.eyeZ());
        if (isImpostor(cluster.most() * pixelsPerRadian / near)) {
            int drawn = drawn(cluster.end() - cluster.first(), cluster.most() * pixelsPerRadian / near);
            for (int plant = cluster.first(); plant < cluster.first() + drawn; plant++) {
                impostors.add(plant);
            }
        } else if (isMesh(cluster.least() * pixelsPerRadian / far)) {
            for (int plant = cluster.first(); plant < cluster.end(); plant++) {
                meshes.get(scene.kind(plant)).add(plant);
            }
        } else {
            for (int plant = cluster.first(); plant < cluster.end(); plant++) {
                double pixels = scene.size(plant) * pixelsPerRadian / distance(plant);
                if (!isMesh(pixels)) {
                    impostors.add(plant);
                }
                if (!isImpostor(pixels)) {
                    meshes.get(scene.kind(plant)).add(plant);
                }
            }
        }
    }

    /** Returns how many of a cluster's plants are drawn, the first ones. @param mostPixels of the largest */
    private static int drawn(int plants, double mostPixels) {
        double fraction = (1 + SHRINK / 2) * Math.min(1, mostPixels / THIN_PIXELS) + SHRINK / 2;
        return (int) Math.min(plants, Math.ceil(plants * fraction));
    }

    /** Returns true if all plants of up to a size have impostors alone. */
    private boolean isImpostor(double mostPixels) {
        return mostPixels < impostorPixels * (1 - MARGIN);
    }

    /** Returns true if all plants from a size on are meshes alone. */
    private boolean isMesh(double leastPixels) {
        return leastPixels > FADE * impostorPixels * (1 + MARGIN);
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
