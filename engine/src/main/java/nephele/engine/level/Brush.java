package nephele.engine.level;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.UprightPrism;
import nephele.engine.math.Vec3;

/** The shape of a solid, with the material and portalability of each face. */
public record Brush(String solidId, ConvexPolyhedron shape, List<BrushFace> faces) {
    /**
     * One face, in the order of {@code shape.faces()}.
     *
     * @param name the face's name in messages: {@code +y}, {@code planes[3]}, {@code slope}, {@code side 2}
     * @param material id, or {@code null} for the default grey
     * @param texture {@code null} if the picture lies as {@code textureMapping} says
     */
    public record BrushFace(
            String name,
            Plane plane,
            List<Vec3> polygon,
            String material,
            boolean portalable,
            TextureMapping textureMapping,
            TexturePlacement texture) {
        private BrushFace on(Plane itsPlane, List<Vec3> itsPolygon) {
            return new BrushFace(name, itsPlane, itsPolygon, material, portalable, textureMapping, texture);
        }

        private BrushFace refusingPortals() {
            return new BrushFace(name, plane, polygon, material, false, textureMapping, texture);
        }

        /** Returns this face with the picture lying elsewhere. */
        public BrushFace with(TexturePlacement other) {
            return new BrushFace(name, plane, polygon, material, portalable, textureMapping, other);
        }
    }

    /**
     * Derives the shape of a solid.
     *
     * @throws IllegalArgumentException with the reason if the solid encloses no bounded volume
     */
    public static Brush of(Solid solid) {
        if (solid instanceof Solid.Box box) {
            requirePositive(box.size());
            return assemble(solid, ConvexPolyhedron.box(Aabb.around(box.centre(), box.size())), boxFaces(box));
        }
        List<BrushFace> faces = faces(solid);
        List<Plane> planes = faces.stream().map(BrushFace::plane).toList();
        boolean isPrism = solid instanceof Solid.Prism;
        return assemble(solid, isPrism ? UprightPrism.of(planes) : ConvexPolyhedron.fromPlanes(planes), faces);
    }

    private static List<BrushFace> faces(Solid solid) {
        if (solid instanceof Solid.Planes planes) {
            return planeFaces(planes);
        } else if (solid instanceof Solid.Wedge wedge) {
            return wedgeFaces(wedge);
        } else if (solid instanceof Solid.Prism prism) {
            return prismFaces(prism);
        }
        throw new IllegalArgumentException("no shape for " + solid.getClass().getSimpleName());
    }

    /** Returns this brush with the faces of these materials not portalable. */
    public Brush refusingPortalsOn(Set<String> materials) {
        if (faces.stream().noneMatch(face -> face.portalable() && materials.contains(face.material()))) {
            return this;
        }
        List<BrushFace> refusing = faces.stream()
                .map(face -> materials.contains(face.material()) ? face.refusingPortals() : face)
                .toList();
        return new Brush(solidId, shape, refusing);
    }

    /** @param planned the faces before their polygons are known */
    private static Brush assemble(Solid solid, ConvexPolyhedron shape, List<BrushFace> planned) {
        return new Brush(
                solid.id(),
                shape,
                shape.faces().stream()
                        .map(face -> planned.get(face.planeIndex()).on(face.plane(), face.polygon()))
                        .toList());
    }

    private static List<BrushFace> boxFaces(Solid.Box box) {
        List<BrushFace> faces = new ArrayList<>(6);
        for (BoxFace side : BoxFace.values()) {
            faces.add(face(box, side.text(), null, box.faces().get(side)));
        }
        return faces;
    }

    /** @param authored {@code null} for a face that is as its solid says */
    private static BrushFace face(Solid solid, String name, Plane plane, Solid.Face authored) {
        Solid.Face own = authored == null ? Solid.Face.INHERITED : authored;
        return new BrushFace(
                name,
                plane,
                List.of(),
                own.material() == null ? solid.material() : own.material(),
                own.portalable() == null ? solid.portalable() : own.portalable(),
                solid.textureMapping(),
                own.texture());
    }

    private static List<BrushFace> planeFaces(Solid.Planes planes) {
        List<BrushFace> faces = new ArrayList<>();
        for (int i = 0; i < planes.planes().size(); i++) {
            Solid.PlaneFace p = planes.planes().get(i);
            faces.add(face(
                    planes,
                    "planes[" + i + "]",
                    Plane.of(p.normal(), p.distanceMetres()),
                    new Solid.Face(p.material(), p.portalable(), p.texture())));
        }
        return faces;
    }

    /**
     * Returns the box's sides without the top and the low side, and the slope from the low bottom edge to the high top
     * edge.
     */
    private static List<BrushFace> wedgeFaces(Solid.Wedge wedge) {
        requirePositive(wedge.size());
        Aabb box = Aabb.around(wedge.centre(), wedge.size());
        Vec3 high = wedge.rising().normal();
        if (high.y() != 0) {
            throw new IllegalArgumentException("a wedge rises towards a horizontal side: +x, -x, +z or -z");
        }
        List<BrushFace> faces = new ArrayList<>();
        for (BoxFace side : BoxFace.values()) {
            Vec3 n = side.normal();
            boolean isLow = n.x() == -high.x() && n.z() == -high.z() && n.y() == 0;
            if (side != BoxFace.PLUS_Y && !isLow) {
                faces.add(face(
                        wedge, side.text(), sidePlane(box, n), wedge.faces().get(side.text())));
            }
        }
        double run = high.x() != 0 ? wedge.size().x() : wedge.size().z();
        double rise = wedge.size().y();
        Vec3 slope = new Vec3(-high.x() * rise, run, -high.z() * rise);
        Plane unit = Plane.of(slope, 0);
        faces.add(face(
                wedge,
                "slope",
                new Plane(unit.nx(), unit.ny(), unit.nz(), unit.signedDistance(wedge.centre())),
                wedge.faces().get("slope")));
        return faces;
    }

    private static Plane sidePlane(Aabb box, Vec3 n) {
        double x = n.x() > 0 ? box.maxX() : box.minX();
        double y = n.y() > 0 ? box.maxY() : box.minY();
        double z = n.z() > 0 ? box.maxZ() : box.minZ();
        return new Plane(n.x(), n.y(), n.z(), n.x() * x + n.y() * y + n.z() * z);
    }

    private static List<BrushFace> prismFaces(Solid.Prism prism) {
        int mostSides = ConvexPolyhedron.MAX_PLANES - 2;
        boolean isBounded = prism.radiusMetres() > 0 && prism.heightMetres() > 0;
        if (!isBounded || prism.sides() < 3 || prism.sides() > mostSides) {
            throw new IllegalArgumentException(
                    "a prism needs a positive radius and height and 3 to " + mostSides + " sides");
        }
        List<BrushFace> faces = new ArrayList<>();
        double y = prism.centre().y();
        Plane top = new Plane(0, 1, 0, y + prism.heightMetres() / 2);
        Plane bottom = new Plane(0, -1, 0, -(y - prism.heightMetres() / 2));
        faces.add(face(prism, "+y", top, prism.faces().get("+y")));
        faces.add(face(prism, "-y", bottom, prism.faces().get("-y")));
        double apothem = prism.radiusMetres() * StrictMath.cos(Math.PI / prism.sides());
        for (int i = 0; i < prism.sides(); i++) {
            double angle = 2 * Math.PI * i / prism.sides();
            double nx = StrictMath.cos(angle);
            double nz = StrictMath.sin(angle);
            double distance = nx * prism.centre().x() + nz * prism.centre().z() + apothem;
            String name = "side " + i;
            faces.add(face(
                    prism, name, new Plane(nx, 0, nz, distance), prism.faces().get(name)));
        }
        return faces;
    }

    private static void requirePositive(Vec3 size) {
        if (!(size.x() > 0 && size.y() > 0 && size.z() > 0)) {
            throw new IllegalArgumentException("every side of the size must be greater than 0");
        }
    }
}
