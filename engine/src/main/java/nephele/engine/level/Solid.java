package nephele.engine.level;

import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;

/** A convex brush. {@code material} and {@code portalable} are the defaults of its faces; material {@code null}: grey. */
public sealed interface Solid {
    String id();

    String material();

    boolean portalable();

    TextureMapping textureMapping();

    /** {@code "kind": "box"}, axis-aligned; {@code faces} by name: +x −x +y −y +z −z (written {@code "+y"}). */
    record Box(
            String id,
            String material,
            boolean portalable,
            TextureMapping textureMapping,
            Vec3 centre,
            Vec3 size,
            Map<BoxFace, Face> faces)
            implements Solid {}

    /** {@code "kind": "planes"}: what lies behind all planes, normal · p ≤ distanceMetres. Bounded and not empty. */
    record Planes(String id, String material, boolean portalable, TextureMapping textureMapping, List<PlaneFace> planes)
            implements Solid {}

    /**
     * {@code "kind": "wedge"}: half of a box, cut from its low edge to its high edge.
     *
     * @param rising the horizontal side on which the wedge has its full height; it falls to zero at the opposite side
     */
    record Wedge(
            String id,
            String material,
            boolean portalable,
            TextureMapping textureMapping,
            Vec3 centre,
            Vec3 size,
            BoxFace rising,
            Map<String, Face> faces)
            implements Solid {}

    /**
     * {@code "kind": "prism"}: a regular upright prism, a column.
     *
     * @param centre of the whole prism
     */
    record Prism(
            String id,
            String material,
            boolean portalable,
            TextureMapping textureMapping,
            Vec3 centre,
            double radiusMetres,
            double heightMetres,
            int sides)
            implements Solid {}

    /** What a face says otherwise than its solid; {@code null} members inherit. */
    record Face(String material, Boolean portalable) {}

    /** One bounding plane; {@code null} members inherit from the solid. */
    record PlaneFace(Vec3 normal, double distanceMetres, String material, Boolean portalable) {}
}
