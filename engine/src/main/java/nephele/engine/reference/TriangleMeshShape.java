package nephele.engine.reference;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.billboard.PlantedModels.Plant;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.reference.MaterialTextures.Bare;
import nephele.engine.reference.MaterialTextures.Spot;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A model's triangles. No ray passes between two that share an edge. Only front faces are visible; both sides cast
 * shadows.
 */
final class TriangleMeshShape implements TracedShape {
    private final PlacedModel model;
    private final WorldTriangles mesh;
    private final double[] corners;
    private final SpatialIndex index;
    private final ItemRayTest meets;
    /** Made once for all plants of a kind; {@code null} before it is asked for. */
    private EmissiveSurfaces.Emitter emitter;

    TriangleMeshShape(PlacedModel model) {
        this.model = model;
        mesh = model.triangles();
        corners = mesh.corners();
        List<Aabb> boxes = new ArrayList<>();
        for (int i = 0; i < mesh.count(); i++) {
            boxes.add(Aabb.of(List.of(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2))));
        }
        index = SpatialIndex.of(boxes);
        meets = (ray, triangle, limit) -> {
            double parameter = RayTriangleIntersection.hitParameter(ray, corners, 9 * triangle);
            return parameter >= 0 && parameter <= limit ? parameter : Double.POSITIVE_INFINITY;
        };
    }

    @Override
    public Aabb bounds() {
        return model.bounds();
    }

    /** Returns the parameter of the first front face. */
    @Override
    public double entry(Ray ray, double least, double most) {
        RayHit hit = new RayHit();
        return nearest(ray, least, most, hit) ? hit.distance() : Double.POSITIVE_INFINITY;
    }

    private boolean nearest(Ray ray, double least, double most, RayHit hit) {
        return index.nearest(ray, most, (r, triangle, limit) -> entry(r, triangle, least), hit);
    }

    /** Returns the triangle that a ray enters at a parameter. */
    int triangle(Ray ray, double parameter) {
        RayHit hit = new RayHit();
        nearest(ray, parameter, TracedItems.BEHIND * parameter, hit);
        return hit.item();
    }

    private double entry(Ray ray, int triangle, double least) {
        double[] normals = mesh.faceNormals();
        double rate = normals[3 * triangle] * ray.directionX()
                + normals[3 * triangle + 1] * ray.directionY()
                + normals[3 * triangle + 2] * ray.directionZ();
        double parameter =
                rate < 0 ? RayTriangleIntersection.hitParameter(ray, corners, 9 * triangle) : Double.POSITIVE_INFINITY;
        return parameter >= Math.max(least, 0) ? parameter : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean intersects(Ray ray, double limit) {
        return index.anyHit(ray, limit, meets);
    }

    @Override
    public boolean shadesItself() {
        return true;
    }

    @Override
    public EmissiveSurfaces.Emitter emitter(int item, SurfaceAppearance looks) {
        Vec3 emission =
                looks.textures().skin(model.authored().material()).material().emission();
        if (emitter == null && EmissiveSurfaces.brightness(emission) > 0) {
            emitter = EmissiveSurfaces.of(new Lit(mesh, emission));
        }
        return emitter;
    }

    /** The triangles, of which all emit the same. */
    private record Lit(WorldTriangles mesh, Vec3 emission) implements EmissiveSurfaces.Triangles {
        @Override
        public int count() {
            return mesh.count();
        }

        @Override
        public Vec3 corner(int triangle, int corner) {
            return mesh.corner(triangle, corner);
        }

        @Override
        public Vec3 radiance(int triangle, Vec3 place) {
            return emission;
        }

        @Override
        public int at(EyePath path) {
            return 0;
        }
    }

    @Override
    public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        return at(new End(path.ray(), path.end(), path.item(), place), UnaryOperator.identity(), place, toEye, looks);
    }

    /** The end of a path in the frame of the triangles. */
    private record End(Ray ray, double parameter, int item, Vec3 place) {}

    /**
     * Returns the point at the end of a path.
     *
     * @param toWorld turns directions of the triangles' frame
     */
    private SurfacePoint at(
            End end, UnaryOperator<Vec3> toWorld, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        int triangle = triangle(end.ray(), end.parameter());
        double[] weights = new double[3];
        RayTriangleIntersection.barycentricWeights(end.place(), corners, 9 * triangle, weights);
        Vector3d normal = new Vector3d();
        double s = 0;
        double t = 0;
        for (int corner = 0; corner < 3; corner++) {
            Vec3 n = mesh.normal(triangle, corner);
            normal.add(weights[corner] * n.x(), weights[corner] * n.y(), weights[corner] * n.z());
            s += weights[corner] * mesh.s(triangle, corner);
            t += weights[corner] * mesh.t(triangle, corner);
        }
        Vec3 smooth = Vec3.of(normal.normalize());
        TriangleTangents texture = TriangleTangents.of(mesh, triangle);
        Spot spot = new Spot(
                s,
                t,
                toWorld.apply(texture.across(smooth)).toVector(),
                toWorld.apply(texture.up(smooth)).toVector());
        Bare bare = new Bare(
                end.item(),
                place,
                toWorld.apply(smooth).toVector(),
                toWorld.apply(mesh.faceNormal(triangle)).toVector(),
                toEye);
        return MaterialTextures.covered(
                bare, looks.textures().skin(model.authored().material()), spot);
    }

    /** A model of a field: the triangles of its kind, turned about the vertical, scaled and moved. */
    static final class Planted implements TracedShape {
        private final TriangleMeshShape kind;
        private final Plant plant;
        private final double cos;
        private final double sin;
        private final Aabb bounds;

        private Planted(TriangleMeshShape kind, Plant plant) {
            this.kind = kind;
            this.plant = plant;
            cos = StrictMath.cos(plant.turn());
            sin = StrictMath.sin(plant.turn());
            Aabb box = kind.bounds();
            List<Vec3> corners = new ArrayList<>();
            for (int i = 0; i < 8; i++) {
                corners.add(plant.foot().addScaled(plant.scale(), turned(box.corner(i))));
            }
            bounds = Aabb.of(corners);
        }

        /** Returns the models of all fields of a level. */
        static List<Planted> of(PlacedLevel placed) {
            PlantedModels planted = PlantedModels.of(placed.level(), placed.statics(), placed.assets());
            List<PlacedModel> models = placed.statics().models().all();
            Map<Integer, TriangleMeshShape> kinds = new HashMap<>();
            List<Planted> all = new ArrayList<>();
            for (Plant plant : planted.plants()) {
                PlacedModel model = models.get(plant.model());
                if (model.authored().isPlanted()) {
                    all.add(new Planted(kinds.computeIfAbsent(plant.kind(), none -> shape(model)), plant));
                }
            }
            return all;
        }

        private static TriangleMeshShape shape(PlacedModel model) {
            WorldTriangles triangles = WorldTriangles.of(model.mesh(), model.worldFromModel());
            return new TriangleMeshShape(new PlacedModel(
                    model.index(),
                    model.authored(),
                    model.mesh(),
                    model.worldFromModel(),
                    triangles,
                    triangles.bounds(),
                    null));
        }

        /** Returns the place of its model in the level's list. */
        int model() {
            return plant.model();
        }

        private Vec3 turned(Vec3 v) {
            return new Vec3(cos * v.x() + sin * v.z(), v.y(), cos * v.z() - sin * v.x());
        }

        private Vec3 turnedBack(double x, double y, double z) {
            return new Vec3(cos * x - sin * z, y, cos * z + sin * x).scaled(1 / plant.scale());
        }

        private Vec3 inKind(double x, double y, double z) {
            return turnedBack(
                    x - plant.foot().x(), y - plant.foot().y(), z - plant.foot().z());
        }

        /** Returns a ray with the same parameters. */
        private Ray inKind(Ray ray) {
            Vec3 origin = inKind(ray.originX(), ray.originY(), ray.originZ());
            Vec3 along = turnedBack(ray.directionX(), ray.directionY(), ray.directionZ());
            return new Ray(origin.x(), origin.y(), origin.z(), along.x(), along.y(), along.z());
        }

        @Override
        public Aabb bounds() {
            return bounds;
        }

        @Override
        public double entry(Ray ray, double least, double most) {
            return kind.entry(inKind(ray), least, most);
        }

        @Override
        public boolean intersects(Ray ray, double limit) {
            return kind.intersects(inKind(ray), limit);
        }

        @Override
        public boolean shadesItself() {
            return true;
        }

        @Override
        public EmissiveSurfaces.Emitter emitter(int item, SurfaceAppearance looks) {
            EmissiveSurfaces.Emitter ofKind = kind.emitter(item, looks);
            return ofKind == null ? null : new Moved(ofKind, this);
        }

        /** The light of the kind where the plant stands. */
        private record Moved(EmissiveSurfaces.Emitter kind, Planted plant) implements EmissiveSurfaces.Emitter {
            @Override
            public double power() {
                return kind.power() * plant.plant.scale() * plant.plant.scale();
            }

            @Override
            public EmissiveSurfaces.Source source(SplittableRandom random) {
                EmissiveSurfaces.Source source = kind.source(random);
                return new EmissiveSurfaces.Source(
                        plant.plant.foot().addScaled(plant.plant.scale(), plant.turned(source.place())),
                        plant.turned(source.normal()),
                        source.radiance(),
                        source.density());
            }

            @Override
            public double density(EyePath path) {
                return kind.density(path);
            }
        }

        @Override
        public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
            End end = new End(inKind(path.ray()), path.end(), path.item(), inKind(place.x(), place.y(), place.z()));
            return kind.at(end, this::turned, place, toEye, looks);
        }
    }

    /**
     * The directions in which the texture coordinates of a triangle of a mesh grow. The shader computes them from
     * differences between neighbouring pixels, which are equal on a flat triangle.
     *
     * @param right the direction of growing s, any length; zero if s does not grow
     * @param down the direction of growing t
     */
    private record TriangleTangents(Vec3 right, Vec3 down) {
        public static TriangleTangents of(WorldTriangles mesh, int triangle) {
            Vec3 n = mesh.faceNormal(triangle);
            Vec3 a = mesh.corner(triangle, 0);
            Vec3 ab = mesh.corner(triangle, 1).minus(a);
            Vec3 ac = mesh.corner(triangle, 2).minus(a);
            Vec3 alongAb = ac.cross(n);
            Vec3 alongAc = n.cross(ab);
            double area = n.dot(ab.cross(ac));
            double s = mesh.s(triangle, 0);
            double t = mesh.t(triangle, 0);
            return new TriangleTangents(
                    Directions.combined(
                            alongAb, (mesh.s(triangle, 1) - s) / area, alongAc, (mesh.s(triangle, 2) - s) / area),
                    Directions.combined(
                            alongAb, (mesh.t(triangle, 1) - t) / area, alongAc, (mesh.t(triangle, 2) - t) / area));
        }

        /** Returns the unit direction in which s grows on a surface with this normal. */
        public Vec3 across(Vec3 normal) {
            Vec3 along = along(right, normal);
            return along == null ? FaceTexture.across(normal) : along;
        }

        /** Returns the unit direction in which t falls on a surface with this normal. */
        public Vec3 up(Vec3 normal) {
            Vec3 along = along(down.negated(), normal);
            return along == null ? normal.cross(across(normal)) : along;
        }

        private static Vec3 along(Vec3 direction, Vec3 normal) {
            double off = direction.dot(normal);
            return Directions.unit(direction.addScaled(-off, normal));
        }
    }
}
