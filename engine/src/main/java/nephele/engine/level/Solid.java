package nephele.engine.level;

import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;

/**
 * A convex brush. {@code material} and {@code portalable} are the defaults of its faces; a material of {@code null} is
 * grey.
 */
public sealed interface Solid {
    String id();

    /** Returns the id of the default material of the faces, or {@code null} for grey. */
    String material();

    boolean portalable();

    TextureMapping textureMapping();

    /** {@code "kind": "box"}, axis-aligned; {@code faces} by name: +x −x +y −y +z −z (written {@code "+y"}). */
    record Box(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written boolean portalable,
            @Written(absent = "\"world\"") TextureMapping textureMapping,
            @Written(required = true, spatial = Spatial.POINT) Vec3 centre,
            @Written(required = true, min = 1e-4, spatial = Spatial.EXTENT) Vec3 size,
            @Written Map<BoxFace, Face> faces)
            implements Solid {}

    /** {@code "kind": "planes"}: the intersection of half-spaces normal · p ≤ distanceMetres; bounded and not empty. */
    record Planes(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written boolean portalable,
            @Written(absent = "\"world\"") TextureMapping textureMapping,
            @Written(required = true, most = 64) List<PlaneFace> planes)
            implements Solid {}

    /**
     * {@code "kind": "wedge"}: half of a box, cut from its low edge to its high edge.
     *
     * @param rising the horizontal side with the full height; the height falls to zero at the opposite side
     */
    record Wedge(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written boolean portalable,
            @Written(absent = "\"world\"") TextureMapping textureMapping,
            @Written(required = true, spatial = Spatial.POINT) Vec3 centre,
            @Written(required = true, min = 1e-4, spatial = Spatial.EXTENT) Vec3 size,
            @Written(required = true, prototype = "\"+x\"") BoxFace rising,
            @Written Map<String, Face> faces)
            implements Solid {}

    /**
     * {@code "kind": "prism"}: a regular upright prism.
     *
     * @param centre the centre of the whole prism
     * @param faces by name: {@code +y}, {@code -y}, {@code side 0} towards +x and on towards +z
     */
    record Prism(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written boolean portalable,
            @Written(absent = "\"world\"") TextureMapping textureMapping,
            @Written(required = true, spatial = Spatial.POINT) Vec3 centre,
            @Written(required = true, min = 1e-4, spatial = Spatial.LENGTH) double radiusMetres,
            @Written(required = true, min = 1e-4, spatial = Spatial.LENGTH) double heightMetres,
            @Written(absent = "16", min = 3, max = 62) int sides,
            @Written Map<String, Face> faces)
            implements Solid {}

    /**
     * The properties of a face that differ from its solid's; {@code null} members inherit.
     *
     * @param texture {@code null} if the picture lies as the solid's mapping says
     */
    record Face(
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written Boolean portalable,
            @Written TexturePlacement texture) {
        /** A face that is as its solid says. */
        public static final Face INHERITED = new Face(null, null, null);
    }

    /**
     * One bounding plane; {@code null} members inherit from the solid.
     *
     * @param texture {@code null} if the picture lies as the solid's mapping says
     */
    record PlaneFace(
            @Written(required = true) Vec3 normal,
            @Written(required = true) double distanceMetres,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written Boolean portalable,
            @Written TexturePlacement texture) {}
}
