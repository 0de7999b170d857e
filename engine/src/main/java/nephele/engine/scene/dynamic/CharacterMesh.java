package nephele.engine.scene.dynamic;

import java.util.List;
import nephele.engine.level.Material;
import nephele.engine.math.Vec3;
import nephele.engine.scene.dynamic.DynamicMesh.Range;

/**
 * The mesh of the player's character: a suit with helmet, pack, gloves and boots. Each part is relative to its own
 * origin, the middle of its bone, which is along y; the character faces −z.
 */
final class CharacterMesh {
    private static final int CLOTH = 0;
    private static final int PANEL = 1;
    private static final int ACCENT = 2;
    private static final int RUBBER = 3;
    private static final int VISOR = 4;
    private static final int SHELL = 5;
    private static final int METAL = 6;
    private static final int LIGHT = 7;

    static final List<Material> MATERIALS = List.of(
            material("cloth", 0.66, 0.63, 0.57, 0.8, 0),
            material("panel", 0.045, 0.15, 0.21, 0.6, 0),
            material("accent", 0.85, 0.3, 0.035, 0.5, 0),
            material("rubber", 0.035, 0.037, 0.04, 0.75, 0),
            material("visor", 0.75, 0.42, 0.13, 0.12, 1),
            material("shell", 0.76, 0.75, 0.72, 0.35, 0),
            material("metal", 0.5, 0.5, 0.52, 0.4, 1),
            new Material("light", new Vec3(0.1, 0.5, 0.6), null, 0.4, null, null, new Vec3(0.2, 1.5, 1.9), 1));

    private final DynamicMesh mesh;
    private final int fineness;
    private int part;

    private CharacterMesh(DynamicMesh mesh, int fineness) {
        this.mesh = mesh;
        this.fineness = fineness;
    }

    private static Material material(String name, double r, double g, double b, double roughness, double metallic) {
        return new Material(name, new Vec3(r, g, b), null, roughness, metallic, null, Vec3.ZERO, 1);
    }

    /**
     * Adds all parts, the right forearm and the head last.
     *
     * @return the range of the whole character, the range without the head, and that without both
     */
    static Range[] add(DynamicMesh mesh, int fineness) {
        int first = mesh.indexCount();
        CharacterMesh character = new CharacterMesh(mesh, fineness);
        for (CharacterPart each : CharacterPart.ALL) {
            if (each != CharacterPart.HEAD && each != CharacterPart.RIGHT_FOREARM) {
                character.add(each);
            }
        }
        Range gunHolding = mesh.since(first);
        character.add(CharacterPart.RIGHT_FOREARM);
        Range headless = mesh.since(first);
        character.add(CharacterPart.HEAD);
        return new Range[] {mesh.since(first), headless, gunHolding};
    }

    private void add(CharacterPart each) {
        part = each.ordinal();
        double side = each.isLeft() ? -1 : 1;
        switch (each) {
            case PELVIS -> pelvis();
            case CHEST -> chest();
            case HEAD -> head();
            case LEFT_UPPER_ARM, RIGHT_UPPER_ARM -> upperArm(side);
            case LEFT_FOREARM, RIGHT_FOREARM -> forearm(side);
            case LEFT_THIGH, RIGHT_THIGH -> thigh(side);
            case LEFT_SHIN, RIGHT_SHIN -> shin();
            case LEFT_FOOT, RIGHT_FOOT -> foot();
        }
    }

    private void put(int material, int sides, Superellipsoid shape) {
        mesh.tag(part, material);
        shape.addTo(mesh, Math.max(8, sides * fineness / 2));
    }

    private void pelvis() {
        put(
                CLOTH,
                12,
                Superellipsoid.at(0, 0, 0)
                        .size(0.155, 0.14, 0.115)
                        .edges(0.75, 0.75)
                        .tapered(-0.05));
        put(RUBBER, 12, Superellipsoid.at(0, 0.15, 0).size(0.132, 0.15, 0.1).edges(0.6, 0.8));
        put(RUBBER, 12, Superellipsoid.at(0, 0.085, 0).size(0.158, 0.03, 0.122).edges(0.35, 0.7));
        put(
                METAL,
                8,
                Superellipsoid.at(0, 0.085, -0.12).size(0.035, 0.026, 0.012).edges(0.3, 0.3));
        put(
                PANEL,
                8,
                Superellipsoid.at(0.15, 0.03, 0.01).size(0.025, 0.06, 0.06).edges(0.4, 0.4));
        put(
                PANEL,
                8,
                Superellipsoid.at(-0.15, 0.03, 0.01).size(0.025, 0.06, 0.06).edges(0.4, 0.4));
    }

    private void chest() {
        put(
                CLOTH,
                16,
                Superellipsoid.at(0, -0.055, 0)
                        .size(0.165, 0.225, 0.115)
                        .edges(0.6, 0.7)
                        .tapered(0.16));
        put(
                SHELL,
                16,
                Superellipsoid.at(0, 0.06, -0.012)
                        .size(0.172, 0.105, 0.118)
                        .edges(0.45, 0.6)
                        .tapered(0.05));
        put(
                PANEL,
                10,
                Superellipsoid.at(0, 0.07, -0.118).size(0.085, 0.06, 0.022).edges(0.35, 0.35));
        put(
                LIGHT,
                8,
                Superellipsoid.at(-0.045, 0.085, -0.139)
                        .size(0.014, 0.014, 0.006)
                        .edges(0.7, 0.7));
        put(
                ACCENT,
                8,
                Superellipsoid.at(0.03, 0.085, -0.138).size(0.032, 0.01, 0.006).edges(0.4, 0.4));
        put(
                METAL,
                8,
                Superellipsoid.at(0.03, 0.052, -0.138).size(0.032, 0.008, 0.006).edges(0.4, 0.4));
        put(
                ACCENT,
                10,
                Superellipsoid.at(0, -0.075, 0).size(0.158, 0.016, 0.119).edges(0.4, 0.7));
        pack();
    }

    private void pack() {
        put(
                SHELL,
                12,
                Superellipsoid.at(0, 0.035, 0.165).size(0.145, 0.185, 0.075).edges(0.4, 0.4));
        put(PANEL, 10, Superellipsoid.at(0, 0.06, 0.238).size(0.1, 0.1, 0.014).edges(0.35, 0.35));
        put(
                ACCENT,
                8,
                Superellipsoid.at(0, 0.13, 0.248).size(0.06, 0.012, 0.008).edges(0.4, 0.4));
        put(
                METAL,
                10,
                Superellipsoid.at(0.135, -0.02, 0.17).size(0.04, 0.15, 0.04).edges(0.5, 1));
        put(
                METAL,
                10,
                Superellipsoid.at(-0.135, -0.02, 0.17).size(0.04, 0.15, 0.04).edges(0.5, 1));
        put(
                PANEL,
                8,
                Superellipsoid.at(0.12, 0.09, 0.01).size(0.026, 0.085, 0.13).edges(0.5, 0.5));
        put(
                PANEL,
                8,
                Superellipsoid.at(-0.12, 0.09, 0.01).size(0.026, 0.085, 0.13).edges(0.5, 0.5));
    }

    private void head() {
        put(SHELL, 24, Superellipsoid.at(0, 0.01, 0.012).size(0.148, 0.158, 0.158));
        put(
                RUBBER,
                20,
                Superellipsoid.at(0, 0.008, -0.06).size(0.125, 0.112, 0.105).edges(0.85, 0.85));
        put(
                VISOR,
                20,
                Superellipsoid.at(0, 0.01, -0.068).size(0.114, 0.097, 0.107).edges(0.9, 0.9));
        put(
                RUBBER,
                16,
                Superellipsoid.at(0, -0.14, 0.008).size(0.112, 0.045, 0.108).edges(0.5, 1));
        put(ACCENT, 8, Superellipsoid.at(0, 0.136, 0.03).size(0.02, 0.04, 0.1).edges(0.9, 0.7));
        put(
                METAL,
                10,
                Superellipsoid.at(0.145, -0.005, 0.025)
                        .size(0.022, 0.045, 0.045)
                        .edges(0.6, 0.7));
        put(
                METAL,
                10,
                Superellipsoid.at(-0.145, -0.005, 0.025)
                        .size(0.022, 0.045, 0.045)
                        .edges(0.6, 0.7));
        put(LIGHT, 8, Superellipsoid.at(0.15, 0.045, -0.035).size(0.012, 0.012, 0.02));
    }

    private void upperArm(double side) {
        put(
                CLOTH,
                12,
                Superellipsoid.at(0, 0, 0)
                        .size(0.058, 0.185, 0.06)
                        .edges(0.65, 1)
                        .tapered(0.12));
        put(
                SHELL,
                12,
                Superellipsoid.at(0.012 * side, 0.13, 0)
                        .size(0.074, 0.068, 0.078)
                        .edges(0.8, 0.85));
        put(ACCENT, 10, Superellipsoid.at(0, 0.045, 0).size(0.063, 0.014, 0.065).edges(0.5, 1));
        put(RUBBER, 10, Superellipsoid.at(0, -0.14, 0).size(0.052, 0.052, 0.054));
    }

    private void forearm(double side) {
        put(
                CLOTH,
                12,
                Superellipsoid.at(0, 0.03, 0)
                        .size(0.05, 0.15, 0.052)
                        .edges(0.6, 1)
                        .tapered(0.12));
        put(
                PANEL,
                10,
                Superellipsoid.at(0.012 * side, -0.015, 0)
                        .size(0.05, 0.075, 0.056)
                        .edges(0.5, 0.8));
        put(RUBBER, 10, Superellipsoid.at(0, -0.105, 0).size(0.047, 0.022, 0.05).edges(0.5, 1));
        put(
                RUBBER,
                10,
                Superellipsoid.at(0, -0.165, -0.004).size(0.033, 0.062, 0.048).edges(0.7, 0.8));
        put(
                RUBBER,
                8,
                Superellipsoid.at(-0.002 * side, -0.215, -0.014)
                        .size(0.026, 0.036, 0.036)
                        .edges(0.8, 0.8));
        put(RUBBER, 8, Superellipsoid.at(-0.018 * side, -0.155, -0.045).size(0.018, 0.042, 0.018));
    }

    private void thigh(double side) {
        put(
                CLOTH,
                12,
                Superellipsoid.at(0, 0, 0).size(0.08, 0.26, 0.088).edges(0.6, 1).tapered(0.15));
        put(
                PANEL,
                10,
                Superellipsoid.at(0.03 * side, 0.03, 0).size(0.06, 0.1, 0.074).edges(0.5, 0.8));
        put(ACCENT, 10, Superellipsoid.at(0, -0.1, 0).size(0.081, 0.012, 0.086).edges(0.5, 1));
    }

    private void shin() {
        put(RUBBER, 10, Superellipsoid.at(0, 0.205, 0.002).size(0.062, 0.062, 0.064));
        put(SHELL, 10, Superellipsoid.at(0, 0.2, -0.04).size(0.05, 0.068, 0.036).edges(0.8, 0.8));
        put(
                CLOTH,
                12,
                Superellipsoid.at(0, 0.045, 0.006)
                        .size(0.061, 0.19, 0.068)
                        .edges(0.6, 1)
                        .tapered(0.14));
        put(PANEL, 12, Superellipsoid.at(0, -0.12, 0.004).size(0.062, 0.1, 0.07).edges(0.45, 0.9));
        put(
                METAL,
                8,
                Superellipsoid.at(0, -0.06, -0.066).size(0.025, 0.016, 0.01).edges(0.4, 0.4));
    }

    /** The origin is the ankle; the sole is 0.09 m below it. */
    private void foot() {
        put(PANEL, 12, Superellipsoid.at(0, 0.0, 0.008).size(0.058, 0.07, 0.068).edges(0.6, 0.9));
        put(
                PANEL,
                12,
                Superellipsoid.at(0, -0.035, -0.05).size(0.055, 0.047, 0.125).edges(0.6, 0.7));
        put(
                RUBBER,
                12,
                Superellipsoid.at(0, -0.073, -0.045).size(0.061, 0.017, 0.142).edges(0.35, 0.65));
        put(
                ACCENT,
                8,
                Superellipsoid.at(0, -0.0, -0.062).size(0.045, 0.012, 0.028).edges(0.6, 0.6));
    }
}
