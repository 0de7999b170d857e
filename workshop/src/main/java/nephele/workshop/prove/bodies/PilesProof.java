package nephele.workshop.prove.bodies;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/**
 * Runs the piles of boxes with which other engines were measured, 600 a family, each for ten seconds at 120 ticks a
 * second. The figures have the names of that comparison's columns. CPU time is one of them; therefore it uses a single
 * thread.
 */
public final class PilesProof implements Proof {
    private static final BoxPile.Family[] FAMILIES = BoxPile.Family.values();
    private static final long PILES_A_FAMILY = 600;
    /** The fraction of the piles that may remain awake, or fall although they could stand. */
    private static final double MOST_UNSETTLED = .01;

    private final int warmPiles;
    private boolean warm;

    /**
     * @param warmPiles number run before the first batch, so that the code is compiled: CPU time is compared with other
     *     engines'
     */
    public PilesProof(int warmPiles) {
        this.warmPiles = warmPiles;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "piles",
                "Piles of boxes of 1 mm to 2.5 m and 1 g to 1 t gain no energy, sink into nothing, pass through"
                        + " nothing and stay in their room; of each family 99 of 100 come to rest, and 99 of 100 towers"
                        + " and loaded small cubes stand.",
                "piles",
                PILES_A_FAMILY * FAMILIES.length,
                300);
    }

    /** Runs units; a unit is a pile, and the families alternate. */
    @Override
    public ProofResult run(long from, long count, Progress progress) {
        warm();
        return ProofResult.ofUnits(from, count, progress, unit -> {
            BoxPile.Family family = FAMILIES[(int) (unit % FAMILIES.length)];
            return Run.run(family, (int) (unit / FAMILIES.length));
        });
    }

    private void warm() {
        for (int i = 0; i < warmPiles && !warm; i++) {
            Run.run(FAMILIES[i % FAMILIES.length], i);
        }
        warm = true;
    }

    /**
     * Converts sums to fractions of the piles, and CPU time to time a step. Rest and standing are judged by their
     * fractions.
     */
    @Override
    public ProofResult judged(ProofResult soFar) {
        List<Figure> figures = new ArrayList<>();
        List<String> failures = new ArrayList<>(soFar.examples());
        long unsettled = 0;
        for (BoxPile.Family family : FAMILIES) {
            String of = family.word() + " ";
            double piles = soFar.value(of + "piles");
            for (Figure figure : soFar.figures()) {
                if (figure.name().startsWith(of)) {
                    figures.add(converted(figure, piles));
                }
            }
            unsettled += judge(soFar, of + "at_rest", piles, failures);
            unsettled += family == BoxPile.Family.DROP ? 0 : judge(soFar, of + "stands", piles, failures);
        }
        return new ProofResult(soFar.units(), soFar.failures() + unsettled, figures, failures);
    }

    private static Figure converted(Figure figure, double piles) {
        if (figure.name().endsWith(" cpu")) {
            double microseconds = 1e6 * figure.value() / (piles * Run.STEPS);
            return Figure.sum(figure.name() + "_us_per_step", microseconds, "µs");
        }
        boolean isCount = figure.join() == Figure.Join.SUM && !figure.name().endsWith(" piles");
        return isCount ? Figure.sum(figure.name(), figure.value() / piles, "") : figure;
    }

    /** Returns the number of piles without the property if it exceeds the limit, else 0. */
    private static long judge(ProofResult result, String property, double piles, List<String> failures) {
        double without = piles - result.value(property);
        if (without <= MOST_UNSETTLED * piles) {
            return 0;
        }
        failures.add(String.format(Locale.ROOT, "%s: not %.0f of %.0f", property, without, piles));
        return (long) without;
    }

    /** A run of a pile of boxes over ten seconds, with measurements after every step. */
    private static final class Run {
        static final int STEPS = 1200;
        private static final double SECONDS_A_STEP = 1.0 / 120;
        private static final double GRAVITY_METRES_PER_SECOND_SQUARED = 9.81;
        private static final double MOST_ENERGY = 1.1;
        private static final double FAST_METRES_PER_SECOND = 25;
        private static final double REST_METRES_PER_SECOND = .02;
        private static final double REST_RADIANS_PER_SECOND = .1;
        private static final double SUNK_METRES = .01;
        private static final double STANDING_METRES = .05;
        private static final double OUTSIDE_METRES = .1;
        private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

        private final BoxPile pile;
        private final BodyEnergy energy = new BodyEnergy();
        private final Vector3d v = new Vector3d();
        private final List<Figure> figures = new ArrayList<>();
        private final List<String> failures = new ArrayList<>();
        private double mostEnergy;
        private double maxSpeed;
        private double maxSpin;
        private boolean gained;
        private boolean escaped;
        private boolean sunkAtChecks;
        private boolean faulty;

        private Run(BoxPile pile) {
            this.pile = pile;
        }

        /**
         * Runs one pile. The figures are:
         *
         * <ul>
         *   <li>{@code energy_gain}: the energy exceeded 1.1 times the initial energy at a step
         *   <li>{@code max_speed}: the greatest speed of a body at a step; {@code max_spin} likewise
         *   <li>{@code fast_any}: a body was faster than 25 m/s at a step
         *   <li>{@code sunk}: a centre was lower than half its smallest edge less 1 cm, at the end
         *   <li>{@code sunk_checks}: the same at the steps 150, 503 and 1200
         *   <li>{@code through}: a centre was more than half the smallest edge and 1 cm under the floor, at the end
         *   <li>{@code escaped}: a centre was 10 cm in a wall or the ceiling or 1 m under the floor, at a step
         *   <li>{@code at_rest}: all bodies were slower than .02 m/s and .1 rad/s at the end
         *   <li>{@code cpu}: CPU time of the solver's steps only, including steps in which all bodies sleep
         *   <li>{@code stands}: the top box lost less than 5 cm of height; for the families that can stand
         * </ul>
         */
        static ProofResult run(BoxPile.Family family, int number) {
            return new Run(BoxPile.of(family, number)).run(family);
        }

        private ProofResult run(BoxPile.Family family) {
            BodyTable table = new BodyTable(List.<Body>copyOf(pile.bodies()));
            RigidStep step = new RigidStep(table, new Vec3(0, -GRAVITY_METRES_PER_SECOND_SQUARED, 0));
            PortalWorld room = PortalWorld.of(pile.room());
            BodyInfluences influences = BodyInfluences.none();
            Bodies bodies = table.start();
            mostEnergy = MOST_ENERGY * joules(bodies);
            long nanos = 0;
            for (int tick = 1; tick <= STEPS; tick++) {
                long before = THREADS.getCurrentThreadCpuTime();
                bodies = step.step(bodies, room, influences, SECONDS_A_STEP);
                nanos += THREADS.getCurrentThreadCpuTime() - before;
                look(bodies, step);
                if (tick == 150 || tick == 503 || tick == STEPS) {
                    sunkAtChecks |= isAnyUnder(bodies, 1);
                }
            }
            String of = family.word() + " ";
            figures.add(Figure.sum(of + "piles", 1, ""));
            wrong(of + "energy_gain", gained, "gains energy");
            figures.add(Figure.greatest(of + "max_speed", maxSpeed, "m/s in " + pile.name()));
            figures.add(Figure.greatest(of + "max_spin", maxSpin, "rad/s in " + pile.name()));
            fraction(of + "fast_any", maxSpeed > FAST_METRES_PER_SECOND);
            wrong(of + "sunk", isAnyUnder(bodies, 1), "sinks");
            fraction(of + "sunk_checks", sunkAtChecks);
            wrong(of + "through", isAnyUnder(bodies, -1), "goes through the floor");
            wrong(of + "escaped", escaped, "escapes");
            fraction(of + "at_rest", isAtRest(bodies));
            figures.add(Figure.sum(of + "cpu", nanos * 1e-9, "s"));
            if (family != BoxPile.Family.DROP) {
                fraction(of + "stands", stands(bodies));
            }
            if (faulty) {
                failures.add(pile.name() + " has a fault");
            }
            return new ProofResult(1, failures.isEmpty() ? 0 : 1, figures, failures);
        }

        private void wrong(String name, boolean is, String what) {
            fraction(name, is);
            if (is) {
                failures.add(pile.name() + " " + what);
            }
        }

        private void fraction(String name, boolean is) {
            figures.add(Figure.sum(name, is ? 1 : 0, ""));
        }

        private void look(Bodies bodies, RigidStep step) {
            gained |= !(joules(bodies) <= mostEnergy);
            faulty |= bodies.frozen() > 0 || step.cutShort() > 0;
            for (int i = 0; i < bodies.size(); i++) {
                maxSpeed = Math.max(maxSpeed, bodies.velocity(i, v).length());
                maxSpin = Math.max(maxSpin, bodies.spin(i, v).length());
                escaped |= !isInside(bodies.centre(i, v));
            }
        }

        private double joules(Bodies bodies) {
            double sum = 0;
            for (int i = 0; i < bodies.size(); i++) {
                Body body = pile.bodies().get(i);
                sum += energy.kinetic(body, bodies, i)
                        + body.massKilograms() * GRAVITY_METRES_PER_SECOND_SQUARED * bodies.centre(i, v).y;
            }
            return sum;
        }

        private boolean isInside(Vector3d centre) {
            double wall = BoxPile.HALF_ROOM_METRES + OUTSIDE_METRES;
            return Math.abs(centre.x) <= wall
                    && Math.abs(centre.z) <= wall
                    && centre.y >= -1
                    && centre.y <= pile.heightMetres() + OUTSIDE_METRES;
        }

        /** Returns true if a centre is more than 1 cm lower than {@code halves} times half its smallest edge. */
        private boolean isAnyUnder(Bodies bodies, int halves) {
            boolean any = false;
            for (int i = 0; i < bodies.size(); i++) {
                Vec3 size = pile.bodies().get(i).size();
                double smallest = Math.min(size.x(), Math.min(size.y(), size.z()));
                any |= !(bodies.centre(i, v).y >= halves * smallest / 2 - SUNK_METRES);
            }
            return any;
        }

        private boolean isAtRest(Bodies bodies) {
            boolean all = true;
            for (int i = 0; i < bodies.size(); i++) {
                all &= bodies.velocity(i, v).length() <= REST_METRES_PER_SECOND;
                all &= bodies.spin(i, v).length() <= REST_RADIANS_PER_SECOND;
            }
            return all;
        }

        private boolean stands(Bodies bodies) {
            int top = bodies.size() - 1;
            return bodies.centre(top, v).y > pile.bodies().get(top).centre().y() - STANDING_METRES;
        }
    }
}
