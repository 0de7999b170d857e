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

    /** Returns this solid with another id and other defaults of its faces; what its faces say stays. */
    Solid with(String newId, String newMaterial, boolean isPortalable, TextureMapping mapping);

    /** Returns a copy with another id. */
    default Solid withId(String newId) {
        return with(newId, material(), portalable(), textureMapping());
    }

    /** {@code "kind": "box"}, axis-aligned; {@code faces} by name: +x −x +y −y +z −z (written {@code "+y"}). */
    record Box(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written boolean portalable,
            @Written(absent = "\"world\"") TextureMapping textureMapping,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
            @Written(required = true, spatial = Spatial.EXTENT) @Range(min = 1e-4) Vec3 size,
            @Written Map<BoxFace, Face> faces)
            implements Solid {
        @Override
        public Box with(String newId, String newMaterial, boolean isPortalable, TextureMapping mapping) {
            return new Box(newId, newMaterial, isPortalable, mapping, centre, size, faces);
        }

        /** Returns this solid with other entries of faces. */
        public Box withFaces(Map<BoxFace, Face> others) {
            return new Box(id, material, portalable, textureMapping, centre, size, others);
        }
    }

    /** {@code "kind": "planes"}: the intersection of half-spaces normal · p ≤ distanceMetres; bounded and not empty. */
    record Planes(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written boolean portalable,
            @Written(absent = "\"world\"") TextureMapping textureMapping,
            @Written(required = true, most = 64) List<PlaneFace> planes)
            implements Solid {
        @Override
        public Planes with(String newId, String newMaterial, boolean isPortalable, TextureMapping mapping) {
            return new Planes(newId, newMaterial, isPortalable, mapping, planes);
        }

        /** Returns this solid with other planes. */
        public Planes withPlanes(List<PlaneFace> others) {
            return new Planes(id, material, portalable, textureMapping, others);
        }
    }

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
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
            @Written(required = true, spatial = Spatial.EXTENT) @Range(min = 1e-4) Vec3 size,
            @Written(required = true, prototype = "\"+x\"") BoxFace rising,
            @Written Map<String, Face> faces)
            implements Solid {
        @Override
        public Wedge with(String newId, String newMaterial, boolean isPortalable, TextureMapping mapping) {
            return new Wedge(newId, newMaterial, isPortalable, mapping, centre, size, rising, faces);
        }

        /** Returns this solid with other entries of faces. */
        public Wedge withFaces(Map<String, Face> others) {
            return new Wedge(id, material, portalable, textureMapping, centre, size, rising, others);
        }
    }

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
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = 1e-4) double radiusMetres,
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = 1e-4) double heightMetres,
            @Written(absent = "16") @Range(min = 3, max = 62) int sides,
            @Written Map<String, Face> faces)
            implements Solid {
        @Override
        public Prism with(String newId, String newMaterial, boolean isPortalable, TextureMapping mapping) {
            return new Prism(
                    newId, newMaterial, isPortalable, mapping, centre, radiusMetres, heightMetres, sides, faces);
        }

        /** Returns this solid with other entries of faces. */
        public Prism withFaces(Map<String, Face> others) {
            return new Prism(
                    id, material, portalable, textureMapping, centre, radiusMetres, heightMetres, sides, others);
        }
    }

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
            @Written(required = true) @Range(min = 1e-9, shape = Range.Shape.DIRECTION) Vec3 normal,
            @Written(required = true) @Range double distanceMetres,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written Boolean portalable,
            @Written TexturePlacement texture) {}
}
