package nephele.engine.render.resource;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.engine.level.planted.PlantedModels.Plant;
import nephele.engine.math.Aabb;
import nephele.engine.math.Pcg3d;
import nephele.engine.math.Vec3;

/** Plants in clusters of near ones; within a cluster their order is random, so that its first ones stand everywhere. */
final class PlantClusters {
    private static final int PER_CLUSTER = 64;

    /** A plant with its place in the level. */
    private record Numbered(Plant plant, int number) {}

    private PlantClusters() {}

    /** Returns the plants, cluster after cluster. */
    static List<List<Plant>> of(List<Plant> plants) {
        Aabb box = Aabb.of(plants.stream().map(Plant::foot).toList());
        double area = box.isEmpty() ? 1 : (box.maxX() - box.minX()) * (box.maxZ() - box.minZ());
        double side = Math.max(1, Math.sqrt(area * PER_CLUSTER / Math.max(1, plants.size())));
        List<Numbered> sorted = new ArrayList<>();
        for (int i = 0; i < plants.size(); i++) {
            sorted.add(new Numbered(plants.get(i), i));
        }
        sorted.sort(Comparator.<Numbered>comparingLong(each -> cell(each.plant().foot(), box, side))
                .thenComparingInt(Numbered::number));
        List<List<Plant>> clusters = new ArrayList<>();
        for (int first = 0; first < sorted.size(); first += PER_CLUSTER) {
            List<Numbered> part = new ArrayList<>(sorted.subList(first, Math.min(first + PER_CLUSTER, sorted.size())));
            part.sort(Comparator.comparingInt(
                    each -> Pcg3d.of(each.number(), 0, 0).x()));
            clusters.add(part.stream().map(Numbered::plant).toList());
        }
        return clusters;
    }

    /** Numbers cells row by row, every second row backwards, so that clusters which reach into the next cell stay compact. */
    private static long cell(Vec3 foot, Aabb box, double side) {
        long column = (long) ((foot.x() - box.minX()) / side);
        long row = (long) ((foot.z() - box.minZ()) / side);
        return (row << 32) + ((row & 1) == 0 ? column : (1L << 31) - column);
    }
}
