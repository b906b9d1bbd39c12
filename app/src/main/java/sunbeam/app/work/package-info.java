/** Work beside other work. */
package sunbeam.app.work;
