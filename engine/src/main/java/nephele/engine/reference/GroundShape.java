package nephele.engine.reference;

import java.util.Optional;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.terrain.GroundProjections;
import nephele.engine.level.terrain.LayerPaint;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.reference.MaterialTextures.Skin;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The triangles of a terrain. Only their upper sides are visible; both sides cast shadows. Pictures lie on the ground in the
 * projections of {@link GroundProjections}.
 */
final class GroundShape implements TracedShape {
    private final StaticShape.HeightGrid grid;
    private final HeightField field;
    private final TerrainLayers layers;
    private final Optional<LayerPaint> paint;

    GroundShape(StaticShape.HeightGrid grid) {
        this.grid = grid;
        field = grid.field();
        layers = TerrainLayers.of(grid.authored());
        paint = grid.painted().map(map -> new LayerPaint(grid.authored(), map));
    }

    @Override
    public Aabb bounds() {
        return field.bounds();
    }

    /** Returns the parameter of the first upper side. */
    @Override
    public double entry(Ray ray, double least, double most) {
        RayHit hit = new RayHit();
        return nearest(ray, least, most, hit) ? hit.distance() : Double.POSITIVE_INFINITY;
    }

    private boolean nearest(Ray ray, double least, double most, RayHit hit) {
        return field.nearest(
                ray,
                most,
                (r, triangle, limit) -> {
                    double parameter = field.entry(r, triangle);
                    return parameter >= least ? parameter : Double.POSITIVE_INFINITY;
                },
                hit);
    }

    @Override
    public boolean intersects(Ray ray, double limit) {
        return field.nearest(ray, limit, (r, triangle, most) -> field.intersection(r, triangle), new RayHit());
    }

    @Override
    public boolean shadesItself() {
        return true;
    }

    @Override
    public EmissiveSurfaces.Emitter emitter(int item, SurfaceAppearance looks) {
        boolean isDark = true;
        for (int i = 0; i < layers.count(); i++) {
            isDark &= EmissiveSurfaces.brightness(emission(i, looks)) == 0;
        }
        return isDark ? null : EmissiveSurfaces.of(new Lit(looks));
    }

    private Vec3 emission(int layer, SurfaceAppearance looks) {
        return looks.textures().skin(layers.material(layer)).material().emission();
    }

    /** The triangles, with the light of the layers' weighted mean. */
    private final class Lit implements EmissiveSurfaces.Triangles {
        private final SurfaceAppearance looks;

        Lit(SurfaceAppearance looks) {
            this.looks = looks;
        }

        @Override
        public int count() {
            return field.triangles();
        }

        @Override
        public Vec3 corner(int triangle, int corner) {
            return field.corner(triangle, corner);
        }

        @Override
        public Vec3 radiance(int triangle, Vec3 place) {
            double[] weights = weights(place, HeightFieldSurface.normal(field, place.x(), place.z()));
            Vec3 sum = Vec3.ZERO;
            for (int i = 0; i < weights.length; i++) {
                sum = sum.addScaled(weights[i], emission(i, looks));
            }
            return sum;
        }

        @Override
        public int at(EyePath path) {
            return triangle(path);
        }
    }

    /** Returns the triangle at the end of a path. */
    private int triangle(EyePath path) {
        RayHit hit = new RayHit();
        nearest(path.ray(), path.end(), TracedItems.BEHIND * path.end(), hit);
        return hit.item();
    }

    /** Returns the weights of the layers at a place. */
    private double[] weights(Vec3 place, Vec3 smooth) {
        double[] weights = new double[layers.count()];
        layers.weights(place.y() - grid.authored().centre().y(), smooth.y(), weights);
        paint.ifPresent(over -> over.over(place.x(), place.z(), weights));
        return weights;
    }

    @Override
    public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        Vector3d faceNormal = field.normal(triangle(path)).toVector();
        Vec3 smooth = HeightFieldSurface.normal(field, place.x(), place.z());
        Mixture mixture = new Mixture(smooth);
        double[] weights = weights(place, smooth);
        for (int i = 0; i < weights.length; i++) {
            if (weights[i] > 0) {
                mixture.add(weights[i], looks.textures().skin(layers.material(i)), place);
            }
        }
        if (weights.length == 0) {
            mixture.add(1, looks.textures().skin(null), place);
        }
        return mixture.point(path.item(), place, faceNormal, toEye, isGlossy(looks.textures()));
    }

    private boolean isGlossy(MaterialTextures textures) {
        for (int i = 0; i < layers.count(); i++) {
            if (!textures.skin(layers.material(i)).material().lambert()) {
                return true;
            }
        }
        return false;
    }

    /** The weighted mean of the layers' materials at a point. */
    private static final class Mixture {
        private final Vector3dc smooth;
        private final GroundProjections projections;
        private final Vector3d colour = new Vector3d();
        private final Vector3d normal = new Vector3d();
        private final Vector3d emission = new Vector3d();
        private double roughness;
        private double metallic;

        Mixture(Vec3 smooth) {
            this.smooth = smooth.toVector();
            projections = new GroundProjections(smooth);
        }

        void add(double weight, Skin skin, Vec3 place) {
            for (int axis = 0; axis < GroundProjections.COUNT; axis++) {
                double fraction = projections.weight(axis);
                if (fraction > 0) {
                    add(weight * fraction, skin, place, axis);
                }
            }
        }

        private void add(double weight, Skin skin, Vec3 place, int axis) {
            Material material = skin.material();
            Vec3 right = projections.across(axis);
            Vec3 top = projections.up(axis);
            double s = right.dot(place) / material.textureMetres();
            double t = -top.dot(place) / material.textureMetres();
            colour.fma(weight, MaterialTextures.colour(skin, s, t));
            emission.fma(weight, material.emission().toVector());
            double rough = material.roughness() == null ? 1 : material.roughness();
            metallic += weight * (material.metallic() == null ? 0 : material.metallic());
            Vector3dc mapped = smooth;
            if (skin.normals() != null) {
                double[] rgba = {1, 1, 1, 1};
                skin.normals().read(s, t, rgba);
                Vector3d across = along(right.toVector());
                Vector3d up = along(top.toVector());
                mapped = FaceTexture.mappedNormal(new Vector3d(rgba[0], rgba[1], rgba[2]), smooth, across, up);
                rough *= rgba[3];
            }
            roughness += weight * rough;
            normal.fma(weight, mapped);
        }

        private Vector3d along(Vector3dc direction) {
            Vector3d tangent = new Vector3d(direction).fma(-smooth.dot(direction), smooth);
            return tangent.normalize();
        }

        SurfacePoint point(int item, Vec3 place, Vector3dc faceNormal, Vector3dc toEye, boolean isGlossy) {
            normal.normalize();
            Brdf gloss = isGlossy ? Brdf.of(colour, roughness, metallic, normal.dot(toEye)) : null;
            return new SurfacePoint(
                    item, place, normal, smooth, faceNormal, colour, gloss, toEye, Vec3.of(emission), false);
        }
    }
}
