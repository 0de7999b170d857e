/** The files of plants and rocks that ship. */
package nephele.workshop.art.plant;
