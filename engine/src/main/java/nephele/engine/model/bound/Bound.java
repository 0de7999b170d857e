package nephele.engine.model.bound;

import nephele.engine.math.Vec3;

/**
 * A bounding volume by which models are tested for contact, from the simplest to the surface itself; its word in a level
 * file is the name in lower case.
 */
public enum Bound {
    SPHERE {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return model.middle(at).minus(centre).length() <= model.sphere().radius() + radius;
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            double distance = a.middle(atA).minus(b.middle(atB)).length();
            return distance <= (a.sphere().radius() + b.sphere().radius()) * (1 + SLACK);
        }
    },
    /** The box along the world's axes around the turned box of the model. */
    BOX {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return box(model, at).upright().nearest(centre) <= radius;
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return box(a, atA).upright().overlaps(box(b, atB).upright());
        }
    },
    ORIENTED_BOX {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return model.tree().box().nearest(at.local(centre)) <= radius;
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return box(a, atA).touches(box(b, atB));
        }
    },
    /** Oriented boxes in a tree, down to that of each triangle. */
    TREE {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return model.tree().touches(at.local(centre), radius, triangle -> true);
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return a.tree().touches(b.tree(), atB.relativeTo(atA), (own, other) -> true);
        }
    },
    /** The triangles themselves, found through the hierarchy. */
    TRIANGLES {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            Vec3 here = at.local(centre);
            return model.tree().touches(here, radius, triangle -> distance(triangle, here) <= radius);
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return a.tree().touches(b.tree(), atB.relativeTo(atA), Bound::haveCommonPoint);
        }
    };

    private static final double SLACK = 1e-9;

    /** Returns whether the volumes of two models have a point in common. */
    public abstract boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB);

    /** Returns whether the volume of a model has a point in common with a ball; a radius in metres. */
    public abstract boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius);

    private static OrientedBox box(BoundedModel model, Pose at) {
        return OrientedBox.of(model.tree().box(), at);
    }

    /**
     * Returns the distance distance the nearest point distance a triangle, which lies inside it or on one distance its edges.
     *
     * @param triangle three corners; without an area, its edges count
     */
    public static double distance(Vec3[] triangle, Vec3 point) {
        Vec3 normal = triangle[1].minus(triangle[0]).cross(triangle[2].minus(triangle[0]));
        double area = normal.length();
        double nearest = Double.POSITIVE_INFINITY;
        boolean isInside = area > 0;
        for (int i = 0; i < 3; i++) {
            Vec3 edge = triangle[(i + 1) % 3].minus(triangle[i]);
            Vec3 from = point.minus(triangle[i]);
            isInside &= normal.cross(edge).dot(from) >= 0;
            nearest = Math.min(nearest, toEdge(edge, from));
        }
        return isInside ? Math.abs(normal.dot(point.minus(triangle[0]))) / area : nearest;
    }

    /** @param from the point, from where the edge starts */
    private static double toEdge(Vec3 edge, Vec3 from) {
        double square = edge.dot(edge);
        double fraction = square > 0 ? Math.max(0, Math.min(1, from.dot(edge) / square)) : 0;
        return from.addScaled(-fraction, edge).length();
    }

    /**
     * Returns whether two triangles have a point in common: no axis separates them. Convex polygons in space are separated
     * by a normal of theirs, by the cross product of an edge of each, or, in one plane, by a perpendicular of an edge in it (Gottschalk
     * 1996, "Separating axis theorem").
     *
     * @param a three corners
     * @param b three corners
     */
    public static boolean haveCommonPoint(Vec3[] a, Vec3[] b) {
        Vec3 normalA = a[1].minus(a[0]).cross(a[2].minus(a[0]));
        Vec3 normalB = b[1].minus(b[0]).cross(b[2].minus(b[0]));
        if (separates(normalA, a, b) || separates(normalB, a, b)) {
            return false;
        }
        for (int i = 0; i < 3; i++) {
            Vec3 edgeA = a[(i + 1) % 3].minus(a[i]);
            Vec3 edgeB = b[(i + 1) % 3].minus(b[i]);
            if (separates(edgeA.cross(normalA), a, b) || separates(edgeB.cross(normalB), a, b)) {
                return false;
            }
            for (int j = 0; j < 3; j++) {
                if (separates(edgeA.cross(b[(j + 1) % 3].minus(b[j])), a, b)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean separates(Vec3 axis, Vec3[] a, Vec3[] b) {
        double a0 = axis.dot(a[0]);
        double a1 = axis.dot(a[1]);
        double a2 = axis.dot(a[2]);
        double b0 = axis.dot(b[0]);
        double b1 = axis.dot(b[1]);
        double b2 = axis.dot(b[2]);
        return Math.max(a0, Math.max(a1, a2)) < Math.min(b0, Math.min(b1, b2))
                || Math.max(b0, Math.max(b1, b2)) < Math.min(a0, Math.min(a1, a2));
    }
}
