package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import nephele.engine.level.Light;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The assignment of layers of the depth texture to punctual lights: one for a spot, six for a point light or a spot
 * wider than 80°. The side of a layer shrinks from {@value #MAX_SIDE_TEXELS} until all fit into the budget; lights that do
 * not fit at {@value #MIN_SIDE_TEXELS} cast no shadow, the weakest first.
 *
 * @param firstLayer per light, −1 without a shadow
 * @param layers one per depth picture to draw
 * @param side texels
 */
public record LightShadowLayers(int[] firstLayer, List<Layer> layers, int side) {
    public static final double NEAR_METRES = 0.05;
    public static final int MAX_SIDE_TEXELS = 512;
    public static final int MIN_SIDE_TEXELS = 128;

    /** 32 MiB of 32-bit depth; OpenGL 4.1 guarantees 2048 layers. */
    private static final int MAX_TEXELS = 1 << 23;

    private static final int MAX_LAYERS = Light.MOST_SHADOW_PICTURES;

    /** Texels beyond a cube's edge in each of its six pictures: a filter near the edge reads one picture only. */
    private static final double GUARD_TEXELS = 2;

    /**
     * One depth picture.
     *
     * @param axis 0–5 for +x −x +y −y +z −z, or 6 for a spot's own axis
     */
    public record Layer(int light, int axis) {}

    public static LightShadowLayers of(List<PunctualLight> lights) {
        List<Integer> byPower = new ArrayList<>();
        for (int i = 0; i < lights.size(); i++) {
            if (lights.get(i).source().castsShadow()) {
                byPower.add(i);
            }
        }
        byPower.sort(Comparator.comparingDouble(i -> -power(lights.get(i))));
        int wanted = byPower.stream().mapToInt(i -> pictures(lights.get(i))).sum();
        int side = MAX_SIDE_TEXELS;
        while (side > MIN_SIDE_TEXELS && (long) side * side * wanted > MAX_TEXELS) {
            side /= 2;
        }
        int available = Math.min(MAX_LAYERS, MAX_TEXELS / (side * side));
        return assigned(lights, byPower, available, side);
    }

    private static LightShadowLayers assigned(
            List<PunctualLight> lights, List<Integer> byPower, int available, int side) {
        int[] first = new int[lights.size()];
        Arrays.fill(first, -1);
        List<Layer> layers = new ArrayList<>();
        for (int light : byPower) {
            int pictures = pictures(lights.get(light));
            if (layers.size() + pictures <= available) {
                first[light] = layers.size();
                for (int i = 0; i < pictures; i++) {
                    layers.add(new Layer(light, pictures == 1 ? 6 : i));
                }
            }
        }
        return new LightShadowLayers(first, List.copyOf(layers), side);
    }

    /** Returns the layers of the {@code lights} most powerful lights; this object if no more lights have any. */
    LightShadowLayers ofMostPowerful(int lights) {
        List<Integer> byPower = layers.stream().map(Layer::light).distinct().toList();
        if (byPower.size() <= lights) {
            return this;
        }
        List<Integer> kept = byPower.subList(0, lights);
        int[] first = firstLayer.clone();
        byPower.subList(lights, byPower.size()).forEach(light -> first[light] = -1);
        return new LightShadowLayers(
                first,
                layers.stream().filter(layer -> kept.contains(layer.light())).toList(),
                side);
    }

    private static double power(PunctualLight light) {
        Vec3 i = light.radiantIntensity();
        return i.x() + i.y() + i.z();
    }

    private static int pictures(PunctualLight light) {
        return light.source().shadowPictures();
    }

    static boolean hasOwnAxis(PunctualLight light) {
        return pictures(light) == 1;
    }

    /** Returns the picture's distance over its half width, which exceeds the light's opening by the guard texels. */
    static double cotangent(PunctualLight light, int side) {
        double guard = 1 - 2 * GUARD_TEXELS / side;
        if (!hasOwnAxis(light)) {
            return guard;
        }
        double c = Math.min(light.cosOuter(), 1 - 1e-7);
        return guard * c / Math.sqrt(1 - c * c);
    }

    /** Returns a spot's horizontal picture axis (Duff et al. 2017, "Building an Orthonormal Basis, Revisited"). */
    static Vector3d right(PunctualLight light) {
        Vec3 n = light.axis();
        double sign = n.z() < 0 ? -1 : 1;
        double a = -1 / (sign + n.z());
        return new Vector3d(1 + sign * n.x() * n.x() * a, sign * n.x() * n.y() * a, -sign * n.x());
    }

    /**
     * Returns the matrix from metres relative to {@code anchor} to a layer's clip space. It may mirror: draw both
     * sides.
     */
    public Matrix4d clipFromAnchor(List<PunctualLight> lights, int layer, Vec3 anchor) {
        PunctualLight light = lights.get(layers.get(layer).light());
        int axis = layers.get(layer).axis();
        Vector3d forward = axis == 6 ? light.axis().toVector() : unit(axis / 2).mul((axis & 1) == 0 ? 1 : -1);
        Vector3d right = axis == 6 ? right(light) : unit((axis / 2 + 1) % 3);
        Vector3d up = axis == 6 ? new Vector3d(forward).cross(right) : unit((axis / 2 + 2) % 3);
        double near = NEAR_METRES;
        double far = farMetres(light);
        double cot = cotangent(light, side);
        Matrix4d clip = new Matrix4d(
                cot,
                0,
                0,
                0,
                0,
                cot,
                0,
                0,
                0,
                0,
                (far + near) / (far - near),
                1,
                0,
                0,
                -2 * far * near / (far - near),
                0);
        Matrix4d view = new Matrix4d(
                right.x, up.x, forward.x, 0, right.y, up.y, forward.y, 0, right.z, up.z, forward.z, 0, 0, 0, 0, 1);
        Vec3 p = light.position();
        return clip.mul(view).translate(anchor.x() - p.x(), anchor.y() - p.y(), anchor.z() - p.z());
    }

    private static double farMetres(PunctualLight light) {
        return Math.max(light.rangeMetres(), 2 * NEAR_METRES);
    }

    /** Returns the factor from the distance along a layer's axis to the stored depth. */
    public static double depthPerMetre(PunctualLight light) {
        return 1 / farMetres(light);
    }

    private static Vector3d unit(int axis) {
        return new Vector3d(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    }
}
