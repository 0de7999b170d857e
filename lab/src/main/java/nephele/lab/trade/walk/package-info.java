/** Subjects that are judged by walks: ticks a second, and the way through a portal. */
package nephele.lab.trade.walk;
